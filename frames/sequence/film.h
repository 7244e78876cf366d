#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "frames/sequence/manifest.h"
#include "frames/sequence/render_request.h"

namespace kerf {

/// A running simulation, or a recorded one, seen frame by frame. It draws nothing itself.
class Film {
 public:
  Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  virtual ~Film() = default;

  /// Called with each step on the way; false stops there.
  using GoOn = std::function<bool(std::uint32_t step)>;
  /// Advances to the end of a step. False if it was stopped before.
  virtual bool advance_to(std::uint32_t step, const GoOn& go_on) = 0;
  /// The present step for a FrameMaker. The film assumes that the frame will be drawn.
  virtual std::vector<std::uint8_t> parcel() = 0;
  /// The record of the present step's picture. The caller fills in `file`, `index` and `pixel_hash`. Events
  /// are those since the frame before.
  virtual FrameRecord record() = 0;
  /// Ends the recording, if there is one, which has all steps if it is `whole`. The film must not be used
  /// afterwards.
  virtual void finish(bool whole) = 0;
  /// After a failure: what was recorded is kept as far as it came, and standard error says where. The film
  /// must not be used afterwards.
  virtual void give_up() noexcept {}
};

/// Throws UsageError for a configuration that cannot work, std::runtime_error for a recording that cannot be
/// read.
std::unique_ptr<Film> make_film(const RenderRequest& request);
/// The same for a request of a recording.
std::unique_ptr<Film> make_recording_film(const RenderRequest& request);

/// The same for requests with panes.
std::unique_ptr<Film> make_panes_film(const RenderRequest& request);
std::unique_ptr<Film> make_panes_of_recording(const RenderRequest& request);

/// As in FrameOptions.
inline int samples_of_renderer(const RenderRequest& request) {
  return request.samples == kSupersampled ? 1 : request.samples;
}

/// The number of steps for which the frames of a film highlight an operator: ten frames, or its name could
/// not be read, but at most a hundred steps.
std::uint32_t highlight_steps(std::uint32_t stride);

/// Adds the operators of step `now` to those of the last `steps` steps.
void keep_recent_operators(std::span<const Event> events, std::uint32_t now, std::uint32_t steps,
                           std::vector<Event>& recent);

/// Objects of `bodies` that move.
template <int D>
std::uint32_t count_moving(std::span<const Body<D>> bodies) {
  const auto moves = [](const Body<D>& body) { return body.mobility == Mobility::moving; };
  return static_cast<std::uint32_t>(std::ranges::count_if(bodies, moves));
}

}  // namespace kerf

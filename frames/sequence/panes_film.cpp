#include "frames/sequence/panes_film.h"

#include <optional>
#include <utility>

#include "frames/sequence/farm/panes_parcel.h"
#include "frames/sequence/pane_of.h"
#include "viz/draw/frame_renderer.h"

namespace kerf {

template <int D>
PanesFilm<D>::PanesFilm(const RenderRequest& request,
                        std::vector<std::unique_ptr<BroadPhase<D>>> broad_phases)
    : names_{request.broad_phase.name},
      is_timed_(request.timed),
      samples_(samples_of_renderer(request)),
      size_(request.size),
      broad_phases_(std::move(broad_phases)) {
  for (const BroadPhaseChoice& choice : *request.beside) names_.push_back(choice.name);
}

template <int D>
std::vector<std::uint8_t> PanesFilm<D>::pack_with_panes(PanesFrame<D> frame) {
  // As FramePlanner: once edges are jagged, they stay so.
  if (samples_ == 0 && frame.bodies.size() >= kManyBodies) samples_ = 1;
  frame.samples = samples_ == 0 ? 4 : samples_;
  frame.is_timed = is_timed_;
  if (columns_ == 0)
    columns_ = choose_columns(size_.width, size_.height, names_.size(), aspect_of(frame.bounds));
  frame.columns = columns_;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    const auto time = is_timed_ ? std::optional(broad_phases_.milliseconds(k)) : std::nullopt;
    frame.panes.push_back(pane_of<D>(names_[k], broad_phases_[k], frame.bodies, frame.bounds, time));
    has_strips_ |= !frame.panes.back().parts.lists.empty();
  }
  frame.has_strips = has_strips_;
  return pack_panes(frame);
}

template class PanesFilm<2>;
template class PanesFilm<3>;

}  // namespace kerf

#pragma once

#include <functional>
#include <map>
#include <memory>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/recording/recording_reader.h"

namespace kerf {

/// Runs the next step of a tree as recorded; unless `swept`, without its pairs. Throws std::runtime_error for
/// a step that the recording does not have, or if it is damaged.
template <int D>
void run_recorded_step(RecordingReader<D>& recording, Bsp<D, Watch>& tree, bool swept = true);

/// Runs a recording's tree again: from the beginning, or from the keyframe before any step. States on the way
/// are kept in memory, so that one step back is a copy, or a copy and one step. Pairs are found only at the
/// end of a seek.
///
/// Throws std::runtime_error for a step that the recording does not have, or if it is damaged.
template <int D>
class Replayer {
 public:
  using OnEvent = std::function<void(const Event&)>;

  /// Keeps states of about `memory` bytes.
  explicit Replayer(std::shared_ptr<RecordingReader<D>> recording, std::size_t memory = kMemory);

  /// Goes to the end of a step; 0 is before the first.
  void seek(std::uint32_t step);
  /// Runs the next step; calls `on_event` with each event, which may read `tree()` meanwhile.
  void advance(const OnEvent& on_event = {});

  [[nodiscard]] std::uint32_t step() const { return tree_.steps(); }
  [[nodiscard]] const Bsp<D, Watch>& tree() const { return tree_; }
  [[nodiscard]] RecordingReader<D>& recording() { return *recording_; }
  /// The approximate memory of the kept states.
  [[nodiscard]] std::size_t memory() const { return kept_bytes_; }

 private:
  static constexpr std::size_t kMemory = std::size_t{128} << 20U;
  struct Kept {
    BspState<D> state;
    std::size_t bytes = 0;
    bool swept = false;  ///< the state has the pairs of its step
  };

  void start_before(std::uint32_t step);
  void run_next(bool swept);
  void keep();
  void forget_farthest(std::uint32_t from);

  std::shared_ptr<RecordingReader<D>> recording_;
  std::size_t memory_;
  Bsp<D, Watch> tree_;
  bool swept_ = true;                   ///< the tree has the pairs of its step
  std::map<std::uint32_t, Kept> kept_;  ///< by step
  std::size_t kept_bytes_ = 0;
};

}  // namespace kerf

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/recording/recording_reader.h"
#include "core/replay/oracle.h"
#include "viz/draw/frame_renderer.h"

namespace kerf {

/// What another engine got wrong in a step of an import, for a picture of it; nothing where its pairs were
/// not judged.
struct TheirErrors {
  std::vector<Pair> missed;
  std::vector<Pair> extra;
  bool are_known = false;

  template <int D>
  TheirErrors(const RecordingReader<D>& recording, std::uint32_t step)
      : are_known(step > 0 && recording.their_step(step)) {
    if (!are_known) return;
    PairJudgement judgement = by_verdict(recording.judged_pairs(step));
    missed = std::move(judgement.missed);
    extra = std::move(judgement.extra);
  }

  [[nodiscard]] Caption counted_in(Caption caption) const {
    if (are_known) caption.theirs = {missed.size(), extra.size()};
    return caption;
  }
};

}  // namespace kerf

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace kerf {

/// How objects move, by a sample of them.
struct Motions {
  float speed = 0;  ///< mean over all, over their sizes; those too fast for any skin count as if they stood
  float fast = 0;   ///< the share of those
};

/// Those of the objects that left their fat boxes in a step.
struct Leaving {
  float share = 0;  ///< of all objects
  Motions motions;  ///< of those who left, looked at only where they are many
};

/// Decides, step by step, whether the pairs of fat boxes are kept or leaves are swept. Keeping pays while few
/// objects leave their fat boxes: to look one up again costs some thirty times what sweeping costs for an
/// object. Who becomes too fast for a skin leaves once and is followed then, and where there are many like it
/// leaves are swept all the same: whether keeping pays shows in how they lie. In the first step nobody's
/// speed is known: leaves are swept, which takes less time and memory.
class KeepOrSweep {
 public:
  /// The share of objects that leave in a step above which sweeping pays.
  static constexpr float kHot = 0.03F;
  /// What an object costs that becomes too fast for a skin, over one that gets another one.
  static constexpr float kFastCost = 0.25F;
  /// The share of fast objects below which keeping pays however they lie, and above which it does not. In 3D
  /// more of them lie in several leaves.
  static constexpr float kFewFast = 0.08F;
  static constexpr float many_fast(int dimension) { return dimension == 2 ? 0.4F : 0.15F; }

  [[nodiscard]] bool keeps() const { return keeps_; }

  /// After a step with kept pairs. A few steps must speak for sweeping, and in the beginning many more, while
  /// skins learn how thick they must be; but if many leave at once whose motions would not begin it, one is
  /// enough: as many fat boxes cost more than sweeping for some time.
  void kept(const Leaving& leaving, int dimension) {
    constexpr float kHopeless = 0.2F;
    constexpr std::uint32_t kLearning = 24;
    constexpr std::uint32_t kEnough = 3;
    ++steps_;
    const float cost = leaving.share * (1 - (1 - kFastCost) * leaving.motions.fast);
    against_ = cost > (steps_ < kLearning ? kHopeless : kHot) ? against_ + 1 : 0;
    const bool is_uproar =
        steps_ >= kLearning && leaving.share > kHopeless && !are_mild(leaving.motions, dimension);
    if (against_ >= kEnough || is_uproar) change();
  }

  /// In such a step, too: what it costs over what it would cost if leaves were swept. Where too many are
  /// restless, the next try is far away, until they are few.
  void kept_at(float cost) {
    constexpr float kDear = 0.85F;
    if (cost < kDear) return;
    change();
    crowded_ = true;
  }

  /// After a step in which leaves were swept. The first motions that are known decide at once.
  void swept(const Motions& motions, int dimension) {
    constexpr float kCool = 0.01F;
    constexpr std::uint32_t kFirst = 4;
    ++steps_;
    const bool is_first = patience_ == 0;
    if (is_first) patience_ = kFirst;
    if (motions.fast < kFewFast) crowded_ = false;
    const bool some_rest = motions.fast < many_fast(dimension);
    against_ = some_rest && motions.speed < kCool ? against_ + 1 : 0;
    if (against_ >= (crowded_ ? kLongest : patience_) || (is_first && are_mild(motions, dimension))) change();
  }

  /// What it remembers, as numbers for a keyframe.
  using Memory = std::array<std::uint32_t, 4>;
  [[nodiscard]] Memory memory() const {
    return {(keeps_ ? 1U : 0U) | (crowded_ ? 2U : 0U), steps_, against_, patience_};
  }
  void resume(const Memory& memory) {
    keeps_ = (memory[0] & 1U) != 0;
    crowded_ = (memory[0] & 2U) != 0;
    steps_ = memory[1];
    against_ = memory[2];
    patience_ = memory[3];
  }

 private:
  /// Whether skins would last, by all that one step can tell.
  static bool are_mild(const Motions& motions, int dimension) {
    constexpr float kMild = 0.015F;
    return motions.fast < many_fast(dimension) && motions.speed < kMild;
  }

  /// Who regrets to have kept before it has paid waits twice as long before the next time. To make all fat
  /// boxes and to sweep leaves with them costs what some five steps cost that sweep.
  void change() {
    constexpr std::uint32_t kPaid = 24;
    constexpr std::uint32_t kPaidWell = 100;
    constexpr std::uint32_t kShortest = 8;
    if (keeps_ && steps_ < kPaid) patience_ = std::min(2 * patience_, kLongest);
    if (keeps_ && steps_ >= kPaidWell) patience_ = kShortest;
    keeps_ = !keeps_;
    steps_ = 0;
    against_ = 0;
  }

  static constexpr std::uint32_t kLongest = 512;

  bool keeps_ = false;
  bool crowded_ = false;        ///< the last regret was for restless objects
  std::uint32_t steps_ = 0;     ///< since the last change
  std::uint32_t against_ = 0;   ///< steps in a row that speak for a change
  std::uint32_t patience_ = 0;  ///< how many of them it takes to keep pairs; 0: no speed was known yet
};

}  // namespace kerf

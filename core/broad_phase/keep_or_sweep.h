#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace kerf {

/// Those of the objects that left their fat boxes in a step.
struct Leaving {
  float share = 0;     ///< of all objects
  float speed = 0;     ///< their mean speed over their sizes
  float restless = 0;  ///< how many of them are too fast for any fat box: as a share of them
};

/// Decides, step by step, whether the pairs of fat boxes are kept or leaves are swept. Keeping pays while few
/// objects leave their fat boxes: to look one up again costs some thirty times what sweeping costs for an
/// object. In the first step nobody's speed is known: leaves are swept, which takes less time and memory.
class KeepOrSweep {
 public:
  /// The share of objects that leave in a step, restless ones by their cost, above which sweeping pays.
  static constexpr float kHot = 0.03F;
  /// What a restless object costs, over one that leaves its fat box and gets another one.
  static constexpr float kRestlessCost = 0.4F;
  /// The speed, over its size, above which an object counts as no faster: what is restless costs the same
  /// however fast it is.
  static constexpr float kDearest = 0.09F;

  [[nodiscard]] bool keeps() const { return keeps_; }

  /// After a step with kept pairs. A few steps must speak for sweeping, and in the beginning many more, while
  /// skins learn how thick they must be; but where objects are fast, one is enough: fat boxes of their size
  /// would overlap without end.
  void kept(const Leaving& leaving) {
    constexpr float kFast = 0.25F;
    constexpr float kHopeless = 0.2F;
    constexpr std::uint32_t kLearning = 24;
    constexpr std::uint32_t kEnough = 3;
    ++steps_;
    const float cost = leaving.share * (1 - (1 - kRestlessCost) * leaving.restless);
    against_ = cost > (steps_ < kLearning ? kHopeless : kHot) ? against_ + 1 : 0;
    if (against_ >= kEnough || (cost > kHot && leaving.speed > kFast)) change();
  }

  /// After a step in which leaves were swept. `speed`: the mean of all objects' speeds over their sizes, none
  /// above kDearest. The first that is known decides at once.
  void swept(float speed) {
    constexpr float kCool = 0.01F;
    constexpr float kMild = 0.015F;
    constexpr std::uint32_t kFirst = 4;
    ++steps_;
    const bool is_first = patience_ == 0;
    if (is_first) patience_ = kFirst;
    against_ = speed < kCool ? against_ + 1 : 0;
    if (against_ >= patience_ || (is_first && speed < kMild)) change();
  }

  /// What it remembers, as numbers for a keyframe.
  using Memory = std::array<std::uint32_t, 4>;
  [[nodiscard]] Memory memory() const { return {keeps_ ? 1U : 0U, steps_, against_, patience_}; }
  void resume(const Memory& memory) {
    keeps_ = memory[0] != 0;
    steps_ = memory[1];
    against_ = memory[2];
    patience_ = memory[3];
  }

 private:
  /// Who soon regrets to have kept waits twice as long before the next time.
  void change() {
    constexpr std::uint32_t kSoon = 100;
    constexpr std::uint32_t kShortest = 8;
    constexpr std::uint32_t kLongest = 512;
    if (keeps_) patience_ = steps_ < kSoon ? std::min(2 * patience_, kLongest) : kShortest;
    keeps_ = !keeps_;
    steps_ = 0;
    against_ = 0;
  }

  bool keeps_ = false;
  std::uint32_t steps_ = 0;     ///< since the last change
  std::uint32_t against_ = 0;   ///< steps in a row that speak for a change
  std::uint32_t patience_ = 0;  ///< how many of them it takes to keep pairs; 0: no speed was known yet
};

}  // namespace kerf

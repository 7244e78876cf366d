#pragma once

#include <functional>
#include <memory>

#include "core/objects/broad_phase.h"
#include "frames/bench/step_block.h"
#include "frames/support/shared_memory.h"

namespace kerf {

/// A subject's answer for one step.
struct StepResult {
  std::uint64_t nanoseconds = 0;
  std::uint64_t added = 0;  ///< of them about: the part of the library's caller (AddedWork), timed afterwards
  std::uint64_t pairs = 0;
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;  ///< invented, or reported twice
};

/// The requests to a subject's process.
enum class Request : char {
  build = 'b',    ///< insert the objects of the block's first step and find their pairs
  run = 'r',      ///< do all steps of the block
  account = 'a',  ///< report the most memory used
  tests = 't',    ///< report how many pairs of boxes were compared in the last step; it may take memory
};

/// A subject's answers about all of its life.
struct Account {
  std::uint64_t bytes = 0;
  std::uint64_t tests = 0;  ///< in the last step; kUnknown if the structure does not count them
  std::uint64_t pairs = 0;  ///< of that step
};
inline constexpr std::uint64_t kUnknown = UINT64_MAX;

/// The table in which a subject's process writes its answers.
class Answers {
 public:
  explicit Answers(std::uint32_t capacity) : memory_(sizeof(Account) + capacity * sizeof(StepResult)) {}

  [[nodiscard]] Account& account() const { return *reinterpret_cast<Account*>(memory_.data()); }
  [[nodiscard]] StepResult& step(std::uint32_t index) const {
    return reinterpret_cast<StepResult*>(memory_.data() + sizeof(Account))[index];
  }

 private:
  SharedMemory memory_;
};

/// The body of a process that measures one algorithm; called for each request.
using Life = std::function<void(char)>;

/// For a broad phase. A step's time is that of passing it what changed and of `step()`; its pairs
/// are compared with the truth afterwards. `block` and `answers` must outlive the process. `one_thread`: see
/// StepTimer.
template <int D>
Life subject_life(std::function<std::unique_ptr<BroadPhase<D>>()> make, const StepBlock<D>& block,
                  const Answers& answers, bool one_thread);

/// For the floor, below which no complete answer can be: read all boxes, write all pairs.
template <int D>
Life floor_life(const StepBlock<D>& block, const Answers& answers);

}  // namespace kerf

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/objects/object_table.h"
#include "core/recording/recording_reader.h"
#include "frames/bench/motion.h"
#include "frames/support/step_range.h"

namespace kerf {

/// Some steps of a recording, looked through once. Its objects get numbers as motions have them: first those
/// that are moving, then the fixed ones, each in the order of the recording's ids; an object that was both
/// has two. Volumes count by their boxes, and boxes that cannot be placed are absent.
template <int D>
class RecordedRun {
 public:
  using Watch = std::function<void(std::uint32_t step)>;

  /// Calls `watch` before it reads a step. Throws as the reader does.
  RecordedRun(std::shared_ptr<RecordingReader<D>> recording, const StepRange& steps, const Watch& watch);

  /// Begins after the range's first step, and has a step for each of the others.
  [[nodiscard]] std::unique_ptr<Motion<D>> motion() const;
  /// That are there in some of the steps.
  [[nodiscard]] std::uint32_t objects() const { return moving_ + fixed_; }
  /// The most that are there at once.
  [[nodiscard]] std::uint32_t most_at_once() const { return most_at_once_; }

 private:
  class Replay;
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// The number of a recorded object as it is now; kNone: it is absent.
  [[nodiscard]] std::uint32_t number(const ObjectTable<D>& table, ObjectId object) const;
  void mark(const ObjectTable<D>& table, ObjectId object);
  void number_all();

  std::shared_ptr<RecordingReader<D>> recording_;
  StepRange steps_;
  std::array<std::vector<std::uint32_t>, 2> numbers_;  ///< by id, of moving and of fixed objects
  std::uint32_t moving_ = 0;
  std::uint32_t fixed_ = 0;
  std::uint32_t most_at_once_ = 0;
  Box<D> bounds_ = Box<D>::empty();
  Scalar box_size_ = 1;
};

}  // namespace kerf

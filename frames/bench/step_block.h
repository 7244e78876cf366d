#pragma once

#include <cstdint>
#include <span>

#include "frames/bench/motion.h"
#include "frames/support/shared_memory.h"

namespace kerf {

/// A fingerprint of the pairs of a step: their number and a sum over them that does not depend on their
/// order.
struct Truth {
  std::uint64_t pairs = 0;
  std::uint64_t checksum = 0;
  friend bool operator==(const Truth&, const Truth&) = default;
};

/// The fingerprint of reported pairs; a pair reported twice counts twice.
Truth truth_of(std::span<const Pair> pairs);

/// A few steps of a motion, written by the bench and read by the algorithms, each in its own process. So
/// every algorithm gets the same boxes, and no timing includes their computation.
template <int D>
class StepBlock {
 public:
  /// Room for `capacity` steps of that motion.
  StepBlock(const Motion<D>& motion, std::uint32_t capacity);

  void clear() { header().steps = 0; }
  /// Appends the present boxes.
  void add(const Motion<D>& motion);
  void set_truth(std::uint32_t step, const Truth& truth) { truths()[step] = truth; }

  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  [[nodiscard]] std::uint32_t steps() const { return header().steps; }
  [[nodiscard]] std::uint32_t objects() const { return objects_; }
  [[nodiscard]] std::uint32_t moving() const { return moving_; }
  /// The boxes of all objects, in the order of their ids.
  [[nodiscard]] std::span<const Box<D>> boxes(std::uint32_t step) const;
  /// The objects that moved, and their boxes.
  [[nodiscard]] std::span<const ObjectId> moved(std::uint32_t step) const;
  [[nodiscard]] std::span<const Box<D>> moved_boxes(std::uint32_t step) const;
  /// The objects that went before the others came; the latter's boxes are in boxes(step).
  [[nodiscard]] std::span<const ObjectId> removed(std::uint32_t step) const;
  [[nodiscard]] std::span<const ObjectId> inserted(std::uint32_t step) const;
  [[nodiscard]] const Truth& truth(std::uint32_t step) const { return truths()[step]; }
  void touch() const { memory_.touch(); }

 private:
  struct Header {
    std::uint32_t steps;
  };
  struct Counts {
    std::uint32_t moved;
    std::uint32_t removed;
    std::uint32_t inserted;
  };
  [[nodiscard]] Header& header() const { return *at<Header>(0); }
  [[nodiscard]] Truth* truths() const { return at<Truth>(truths_at_); }
  [[nodiscard]] Box<D>* slot(std::uint32_t step) const;
  [[nodiscard]] Box<D>* moved_slot(std::uint32_t step) const;
  [[nodiscard]] ObjectId* ids(std::uint32_t step) const;
  [[nodiscard]] ObjectId* changes(std::uint32_t step) const;
  [[nodiscard]] Counts& counts(std::uint32_t step) const { return at<Counts>(counts_at_)[step]; }
  template <class T>
  [[nodiscard]] T* at(std::size_t offset) const {
    return reinterpret_cast<T*>(memory_.data() + offset);
  }

  std::uint32_t capacity_;
  std::uint32_t objects_;
  std::uint32_t moving_;
  std::uint32_t most_changes_;
  bool all_move_;
  std::size_t truths_at_ = 0;
  std::size_t counts_at_ = 0;
  std::size_t ids_at_ = 0;
  std::size_t boxes_at_ = 0;
  std::size_t moved_at_ = 0;
  std::size_t changes_at_ = 0;
  SharedMemory memory_;
};

}  // namespace kerf

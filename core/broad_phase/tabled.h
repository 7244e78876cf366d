#pragma once

#include <vector>

#include "core/base/float_mode.h"
#include "core/base/pair_list.h"
#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"

namespace kerf {

/// The common part of our broad phases that find all pairs anew in each step: the table of objects, the list
/// of placed objects, and the pairs.
template <int D>
class Tabled : public BroadPhase<D> {
 public:
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) final;
  Status move(ObjectId object, const Box<D>& box) final {
    const UsualComparisons floats;
    return track(object, table_.move(object, box));
  }
  Status remove(ObjectId object) final;
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) final;
  void step() final;
  [[nodiscard]] std::span<const Pair> pairs() const final { return pairs_.pairs(); }

  /// Has each step measure `arrange_seconds`. To read the time takes as long as some tens of boxes.
  void time_arranging() { times_arranging_ = true; }
  /// The seconds that the last `step()` spent on its structure, before it searched for pairs; 0 unless it
  /// measures them.
  [[nodiscard]] double arrange_seconds() const { return arrange_seconds_; }

 protected:
  /// Updates the structure, if there is any, to `placed()` and their boxes.
  virtual void arrange() {}
  /// Writes the pairs of `placed()` to `pairs`, which is empty.
  virtual void find_pairs(PairList& pairs) = 0;

  [[nodiscard]] const ObjectTable<D>& table() const { return table_; }
  /// The placed objects, in the order of their ids.
  [[nodiscard]] const std::vector<ObjectId>& placed() const { return placed_; }

 private:
  Status track(ObjectId object, Status status);
  void list_placed();

  ObjectTable<D> table_;
  std::vector<ObjectId> placed_;
  std::vector<std::uint8_t> listed_;  ///< per object: it is in placed_
  bool list_is_old_ = false;
  bool times_arranging_ = false;
  double arrange_seconds_ = 0;
  PairList pairs_;
};

}  // namespace kerf

#pragma once

#include <cstdint>
#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/objects/structure.h"
#include "frames/rivals/rival.h"

namespace kerf {

/// The common part of all rivals: statuses, the objects that the library holds now, and the list of pairs. A
/// rival defines how an object enters the library, changes and leaves it, and how pairs are found.
template <int D>
class RivalBase : public BroadPhase<D>, public AddedWork, public SelfDescribing<D> {
 public:
  explicit RivalBase(const RivalHints<D>& hints, Intake intake);

  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) final;
  Status move(ObjectId object, const Box<D>& box) final;
  Status remove(ObjectId object) final;
  void step() final;
  [[nodiscard]] std::span<const Pair> pairs() const final { return pairs_; }
  std::uint64_t time_added() final;
  void describe(StructureParts<D>& parts) const final { tell_structure(parts); }

 protected:
  virtual void add(ObjectId object, const Box<D>& box, bool fixed) = 0;
  virtual void change(ObjectId object, const Box<D>& box) = 0;
  virtual void drop(ObjectId object) = 0;
  /// The library's search for pairs. Calls `report` or `report_candidate` for each reported pair.
  virtual void find_pairs() = 0;
  /// Calls them for the pairs that the library keeps and that its caller has to visit.
  virtual void collect_pairs() {}
  /// Describes what the library's headers show of its structure, or why they show nothing.
  virtual void tell_structure(StructureParts<D>& parts) const = 0;

  /// The pairs that the library left to be tested are the tests that are known of it.
  void tell_candidates(StructureParts<D>& parts) const {
    for (const auto& [a, b] : candidates_) parts.tell_tested(a, b);
    parts.end_tested();
  }

  /// The last box given to the library.
  [[nodiscard]] const Box<D>& shown(ObjectId object) const { return shown_[object.index()]; }
  [[nodiscard]] bool is_fixed(ObjectId object) const { return fixed_[object.index()] != 0; }

  /// Adds a pair that the library guarantees.
  void report(ObjectId a, ObjectId b) {
    if ((fixed_[a.index()] & fixed_[b.index()]) == 0) pairs_.push_back(make_pair(a, b));
  }
  /// Adds a pair that the library leaves its caller to test.
  void report_candidate(ObjectId a, ObjectId b) { candidates_.push_back({a, b}); }

 private:
  void show(ObjectId object, const Box<D>& given);
  /// The caller's part of a step.
  void complete();

  Intake intake_;
  ObjectTable<D> table_;
  std::vector<Box<D>> shown_;
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint8_t> held_;  ///< per object: the library has it
  std::vector<Pair> candidates_;
  std::vector<Pair> pairs_;
  std::size_t guaranteed_ = 0;  ///< pairs of `find_pairs` alone, in the last step
  std::size_t left_ = 0;        ///< candidates likewise
};

}  // namespace kerf

#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "core/objects/object_table.h"
#include "core/recording/recording_reader.h"
#include "core/recording/theirs.h"

namespace kerf {

/// What another engine's pairs are judged by beside the objects that the tree has: their boxes as they were
/// given, and their filters.
template <int D>
class TheirWorld {
 public:
  void apply(const TheirChanges<D>& changes);

  /// Of a placed object. Where the engine's numbers are floats it is the tree's box.
  [[nodiscard]] GivenBox<D> box(const ObjectTable<D>& objects, ObjectId object) const;
  [[nodiscard]] const std::optional<GivenBox<D>>& given(ObjectId object) const;
  [[nodiscard]] GivenFilter filter(ObjectId object) const;
  /// Of two placed objects that are not both fixed: whether they overlap in the precision given.
  [[nodiscard]] bool overlap(const ObjectTable<D>& objects, const Pair& pair) const;
  /// Whether they may overlap with the margin that the engine has by design.
  [[nodiscard]] bool overlap_with_margin(const ObjectTable<D>& objects, const Pair& pair,
                                         const PairDesign& design) const;

 private:
  // A recording that was forged may name any object: the cost is that of their count.
  std::unordered_map<ObjectId, std::optional<GivenBox<D>>> boxes_;
  std::unordered_map<ObjectId, GivenFilter> filters_;
};

/// The verdicts on pairs of a step, in the order of the verdicts, then of the pairs: right ones have none.
/// `truth` are the pairs of the objects' floats, sorted: rounded outward, they lack none.
template <int D>
std::vector<JudgedPair> judge_theirs(std::span<const Pair> reported, std::span<const Pair> truth,
                                     const ObjectTable<D>& objects, const TheirWorld<D>& world,
                                     const PairDesign& design);

/// Whether two objects overlap at the end of a step in the precision in which their boxes were given, which
/// the recording knows; both are placed in `objects`, the tree's of that step.
template <int D>
bool overlap_as_given(const RecordingReader<D>& recording, std::uint32_t step, const ObjectTable<D>& objects,
                      const Pair& pair);

}  // namespace kerf

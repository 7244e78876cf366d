#pragma once

#include <cstdint>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_boxes.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/mode.h"
#include "core/bsp/pair_bits.h"
#include "core/bsp/step_context.h"
#include "core/trace/reporter.h"

namespace kerf {

/// The step for objects of which many move: all are placed in one pass down the tree, and leaves are swept by
/// vectors of bytes. Its memory is kept between steps.
template <int D>
class SweptStep {
 public:
  /// Brings the entries up to date with the requests after a step of mode `before`, for one of mode `mode`,
  /// either of which finds pairs by tight boxes. Returns how many objects changed.
  template <class Trace>
  std::uint64_t place_all(const StepContext<D>& step, Mode before, Mode mode, Reporter<Trace>& reporter);
  /// The same where the root is a leaf and objects only moved: all stay in it.
  static void move_in_root(const StepContext<D>& step);
  /// No leaf has its boxes copied: call it before each placement. `changed`: the objects of which the tree's
  /// boxes are not the latest, and `rows` whether rows of bits pay for so few.
  void begin_step(const Tree<D>& tree, std::span<const ObjectId> changed, bool rows);
  /// Whether the pairs are known as rows of bits: `find_in_rows` finds them.
  [[nodiscard]] bool has_rows(const ObjectTable<D>& table) const { return rows_.have_room(table); }
  void find_in_rows(const ObjectTable<D>& table, PairBuffer& pairs) { rows_.find(table, pairs); }
  /// These are the pairs that were found in the leaves: there are rows of them from now on, if they pay.
  void end_step(const ObjectTable<D>& table, std::span<const Pair> pairs);
  /// Appends the pairs of a leaf. Different leaves can be swept at the same time.
  void find(const Tree<D>& tree, NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs);
  /// Whether leaves had their boxes copied when all objects were placed last.
  [[nodiscard]] bool copies_boxes() const { return leaf_boxes_.wanted(); }
  /// The next step finds the pairs in the leaves.
  void forget_pairs() { rows_.forget(); }
  /// Gives back memory that another mode does not need.
  void forget() { *this = {}; }

 private:
  LeafBoxes<D> leaf_boxes_;  ///< of all leaves, where the table exceeds what is read fast
  PairBits<D> rows_;
  bool wants_rows_ = false;
};

}  // namespace kerf

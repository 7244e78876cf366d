#pragma once

#include <cstdint>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_boxes.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/mode.h"
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
  /// No leaf has its boxes copied: call it before each placement.
  void begin_step(const Tree<D>& tree) { leaf_boxes_.begin(tree, false); }
  /// Appends the pairs of a leaf. Different leaves can be swept at the same time.
  void find(const Tree<D>& tree, NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs);
  /// Whether leaves had their boxes copied when all objects were placed last.
  [[nodiscard]] bool copies_boxes() const { return leaf_boxes_.wanted(); }
  /// Gives back memory that another mode does not need.
  void forget() { leaf_boxes_ = {}; }

 private:
  LeafBoxes<D> leaf_boxes_;  ///< of all leaves, where the table exceeds what is read fast
};

extern template class SweptStep<2>;
extern template class SweptStep<3>;

}  // namespace kerf

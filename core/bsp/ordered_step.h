#pragma once

#include <cstdint>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/step_context.h"
#include "core/trace/reporter.h"

namespace kerf {

/// The paper's step: each object is placed by itself, and each leaf is swept along its ordered list. It has
/// no memory of its own.
template <int D>
class OrderedStep {
 public:
  /// Brings the entries up to date with the requests, object by object. Returns how many objects changed
  /// leaves.
  template <class Trace>
  static std::uint64_t place(const StepContext<D>& step, Reporter<Trace>& reporter);
  /// Renews and orders the lists of the leaves that something changed.
  static void sort(Tree<D>& tree);
  /// Appends the pairs of a leaf whose list is ordered.
  static void find(const Tree<D>& tree, NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs);
};

}  // namespace kerf

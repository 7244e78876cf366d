#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"

namespace kerf::python {

/// The pairs of a broad phase as arrays, without a copy. An array looks at the broad phase's own memory; if
/// it is still there when a step would write into that, the array gets the memory, and the broad phase other
/// one.
class PairLists {
 public:
  /// The pairs of the last step, which lie in the broad phase: (m, 2) uint32, read-only. One array a step.
  [[nodiscard]] pybind11::array array(std::span<const Pair> latest);
  /// Call it before the broad phase writes into its list or ends. `exchange` is Bsp::exchange_pairs.
  void let_go(const std::function<void(PairBuffer&)>& exchange);

 private:
  struct List {
    PairBuffer memory;       ///< spare, or what an array of an earlier step looks at
    bool has_array = false;  ///< an array looks at it, or at the latest pairs
  };
  [[nodiscard]] std::shared_ptr<List> spare();

  std::vector<std::shared_ptr<List>> lists_;
  std::shared_ptr<List> latest_;
};

}  // namespace kerf::python

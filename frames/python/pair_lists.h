#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"

namespace kerf::python {

/// The memory of a broad phase's pairs, shared with the arrays that Python got: each array keeps its list,
/// and no step writes into a list that an array still has.
class PairLists {
 public:
  /// A list that no array has. Its memory is that of an earlier one, if there is one to spare.
  PairBuffer& spare();
  /// The list that `spare` returned last is the latest now.
  void publish();
  [[nodiscard]] std::span<const Pair> latest() const;
  /// The latest list as an array, without a copy: (m, 2) uint32, read-only.
  [[nodiscard]] pybind11::array array() const;

 private:
  using List = std::shared_ptr<PairBuffer>;
  static constexpr std::size_t kKept = 4;

  std::vector<List> lists_;
  List next_;
  List latest_;
};

}  // namespace kerf::python

#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/ids.h"
#include "core/geometry/box.h"

namespace kerf::python {

/// Boxes from Python, as rows of floats. Of a float32 array in C order they are the array's own memory;
/// anything else is copied, and numbers with more digits are rounded outward, so that no overlap is lost.
template <int D>
class BoxRows {
 public:
  /// Throws ValueError that names the row unless the shape is (n, 2, D), the numbers are real, none is NaN,
  /// and no lower corner lies above its upper one. `what` is the argument's name. Rounded boxes lie in
  /// `room` if there is one: its memory serves one call after another.
  BoxRows(const pybind11::handle& given, const std::string& what, AppendBuffer<Box<D>>* room = nullptr);

  [[nodiscard]] std::span<const Box<D>> all() const { return boxes_; }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }

 private:
  void take_floats(const pybind11::array& array, const std::string& what);
  void take_doubles(const pybind11::array& array, const std::string& what, AppendBuffer<Box<D>>& room);

  pybind11::array held_;
  AppendBuffer<Box<D>> rounded_;
  std::span<const Box<D>> boxes_;
};

/// Throws ValueError unless the array has rows of a lower and an upper corner; `dimension` 0: of either.
void check_box_shape(const pybind11::array& array, int dimension, const std::string& what);

/// Ids from Python: a list of whole numbers from 0 to 2^32 - 2.
class IdRows {
 public:
  /// Throws ValueError that names the row.
  IdRows(const pybind11::handle& given, const std::string& what);

  [[nodiscard]] std::span<const ObjectId> all() const { return ids_; }
  [[nodiscard]] std::size_t size() const { return ids_.size(); }

 private:
  std::vector<ObjectId> ids_;
};

/// One truth value for each of `count` rows, from a single one or a list. Throws ValueError.
std::vector<std::uint8_t> flag_rows(const pybind11::handle& given, std::size_t count,
                                    const std::string& what);

/// Flags of arrays that can be read as plain memory, after a copy where they cannot.
inline constexpr int kInOrder =
    pybind11::array::c_style | pybind11::array::forcecast | pybind11::detail::npy_api::NPY_ARRAY_ALIGNED_;

/// Any array-like of Python's as an array; throws ValueError if it is none.
pybind11::array as_array(const pybind11::handle& given, const std::string& what);
/// Real numbers, in plain memory; throws ValueError for anything else.
pybind11::array_t<double> number_array(const pybind11::handle& given, const std::string& what);

/// "(3, 2)"
std::string shape_text(const pybind11::array& array);

/// A new array with a copy of the pairs: (m, 2), uint32, read-only.
pybind11::array pair_array(std::span<const Pair> pairs);
/// A new array with a copy of the ids: (n,), uint32, read-only.
pybind11::array id_array(std::span<const ObjectId> ids);
/// A new array with a copy of the boxes: (n, 2, D), float32.
template <int D>
pybind11::array box_array(std::span<const Box<D>> boxes);
/// The same array, which can no longer be written to.
pybind11::array read_only(pybind11::array array);

}  // namespace kerf::python

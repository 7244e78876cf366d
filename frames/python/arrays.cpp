#include "frames/python/arrays.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/base/float_mode.h"
#include "core/kernels/box_rows.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

[[noreturn]] void fail(const std::string& what, const std::string& problem) {
  throw py::value_error(what + ": " + problem);
}

std::string dtype_text(const py::array& array) { return py::str(array.dtype()); }

template <int D, class Number>
std::size_t first_bad_row(const Number* numbers, std::size_t rows) {
  std::size_t row = 0;
  while (are_boxes<D>(numbers + row * 2 * D, 1) && row + 1 < rows) ++row;
  return row;
}

/// What is wrong with a box.
template <class Number>
std::string fault_of(const Number* box, std::size_t dimension) {
  if (std::any_of(box, box + 2 * dimension, [](Number x) { return std::isnan(x); }))
    return "has a NaN; leave such objects out, or give them a box of their own";
  for (std::size_t i = 0; i < dimension; ++i)
    if (box[i] > box[dimension + i])
      return "has its lower corner above its upper one on axis " + std::to_string(i) + " (" +
             std::to_string(box[i]) + " > " + std::to_string(box[dimension + i]) +
             "); a row is [[min_x, ...], [max_x, ...]]";
  return "is no box";
}

template <int D, class Number>
[[noreturn]] void fail_at_bad_row(const Number* numbers, std::size_t rows, const std::string& what) {
  const std::size_t row = first_bad_row<D>(numbers, rows);
  fail(what, "row " + std::to_string(row) + " " + fault_of(numbers + row * 2 * D, std::size_t{D}));
}

/// Doubles hold whole numbers up to 2^53.
void check_whole_numbers(std::span<const double> numbers, std::size_t row_size, const std::string& what) {
  constexpr double kLimit = 9'007'199'254'740'992.0;
  const auto large = std::ranges::find_if(numbers, [](double x) { return std::abs(x) >= kLimit; });
  if (large == numbers.end()) return;
  const auto row = static_cast<std::size_t>(large - numbers.begin()) / row_size;
  fail(what,
       "row " + std::to_string(row) +
           " has a whole number beyond 2^53, which is not exact in float64; convert the array yourself");
}

void check_number_type(const py::array& array, const std::string& what) {
  const char kind = array.dtype().kind();
  const bool real = kind == 'f' || kind == 'i' || kind == 'u';
  if (!real || array.itemsize() > 8)
    fail(what, "the dtype is " + dtype_text(array) + "; give float32, float64 or whole numbers");
}

/// The type has been checked: only memory can be short.
py::array_t<double> doubles_of(const py::array& array) {
  auto doubles = py::array_t<double, kInOrder>::ensure(array);
  if (!doubles) throw std::bad_alloc();
  return doubles;
}

/// Whether it is an array of numpy.ma with something masked. The type alone says that a plain array is none.
bool has_mask(const py::handle& given) {
  if (!py::isinstance<py::array>(given) || py::type::of(given).is(py::type::of(py::array()))) return false;
  if (!py::hasattr(given, "mask")) return false;
  return py::bool_(py::module_::import("numpy").attr("any")(given.attr("mask")));
}

/// A list or tuple of arrays has the masks of all.
bool has_masks(const py::handle& given) {
  if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) return has_mask(given);
  const auto items = py::reinterpret_borrow<py::sequence>(given);
  return std::any_of(items.begin(), items.end(), &has_mask);
}

}  // namespace

py::array as_array(const py::handle& given, const std::string& what) {
  if (has_masks(given))
    fail(what, "this is a masked array, and a mask is not heeded; leave the masked rows out");
  try {
    return {py::reinterpret_borrow<py::object>(given)};
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
  }
  fail(what, "this is no array of numbers");
}

std::string shape_text(const py::array& array) { return py::str(py::tuple(py::object(array.attr("shape")))); }

void check_box_shape(const py::array& array, int dimension, const std::string& what) {
  const auto is_asked = [&](py::ssize_t of) { return dimension == 0 ? of == 2 || of == 3 : of == dimension; };
  if (array.ndim() == 3 && array.shape(1) == 2 && is_asked(array.shape(2))) return;
  if (array.ndim() == 1 && array.size() == 0) return;
  const auto shape = [](const std::string& d) { return "(n, 2, " + d + ")"; };
  std::string problem =
      "the shape is " + shape_text(array) + ", but must be " +
      (dimension == 0 ? shape("2") + " or " + shape("3") : shape(std::to_string(dimension))) +
      ": n rows of a lower and an upper corner";
  if (array.ndim() == 2 && array.shape(1) % 2 == 0 && is_asked(array.shape(1) / 2))
    problem += "; rows of min_x, ..., max_x, ... become that by .reshape(-1, 2, " +
               std::to_string(array.shape(1) / 2) + ")";
  fail(what, problem);
}

py::array_t<double> number_array(const py::handle& given, const std::string& what) {
  const py::array array = as_array(given, what);
  check_number_type(array, what);
  return doubles_of(array);
}

template <int D>
BoxRows<D>::BoxRows(const py::handle& given, const std::string& what, AppendBuffer<Box<D>>* room) {
  static_assert(sizeof(Box<D>) == 2 * D * sizeof(float));
  const DefaultFloats usual;
  const py::array array = as_array(given, what);
  check_box_shape(array, D, what);
  check_number_type(array, what);
  if (array.size() == 0) return;
  if (array.dtype().kind() == 'f' && array.itemsize() == sizeof(float)) {
    take_floats(array, what);
  } else {
    take_doubles(array, what, room != nullptr ? *room : rounded_);
  }
}

template <int D>
void BoxRows<D>::take_floats(const py::array& array, const std::string& what) {
  const auto floats = py::array_t<float, kInOrder>::ensure(array);
  if (!floats) throw std::bad_alloc();
  const auto rows = static_cast<std::size_t>(floats.shape(0));
  if (!are_boxes<D>(floats.data(), rows)) fail_at_bad_row<D>(floats.data(), rows, what);
  held_ = floats;
  boxes_ = {reinterpret_cast<const Box<D>*>(floats.data()), rows};
}

template <int D>
void BoxRows<D>::take_doubles(const py::array& array, const std::string& what, AppendBuffer<Box<D>>& room) {
  const auto doubles = doubles_of(array);
  const std::span<const double> numbers(doubles.data(), static_cast<std::size_t>(doubles.size()));
  const std::size_t rows = numbers.size() / (2 * D);
  room.clear();
  if (!round_boxes<D>(numbers.data(), rows, room.reserve(rows)))
    fail_at_bad_row<D>(numbers.data(), rows, what);
  if (array.dtype().kind() != 'f') check_whole_numbers(numbers, 2 * D, what);
  room.commit(rows);
  boxes_ = room.all();
}

IdRows::IdRows(const py::handle& given, const std::string& what) {
  const py::array array = as_array(given, what);
  if (array.size() == 0 && array.ndim() <= 1) return;
  const char kind = array.dtype().kind();
  if (array.ndim() != 1)
    fail(what, "the shape is " + shape_text(array) + ", but must be (n,): one id for each row");
  if (kind != 'i' && kind != 'u') fail(what, "the dtype is " + dtype_text(array) + "; ids are whole numbers");
  const auto take = [&](const auto& numbers) {
    ids_.reserve(static_cast<std::size_t>(numbers.size()));
    for (py::ssize_t row = 0; row < numbers.size(); ++row) {
      const auto id = numbers.data()[row];
      if (id < 0 || static_cast<std::uint64_t>(id) >= ObjectId::none().value)
        fail(what,
             "row " + std::to_string(row) + " is " + std::to_string(id) + "; ids go from 0 to 2^32 - 2");
      ids_.push_back({static_cast<std::uint32_t>(id)});
    }
  };
  if (kind == 'u') {
    take(py::array_t<std::uint64_t, kInOrder>(array));
  } else {
    take(py::array_t<std::int64_t, kInOrder>(array));
  }
}

std::vector<std::uint8_t> flag_rows(const py::handle& given, std::size_t count, const std::string& what) {
  const py::array array = as_array(given, what);
  const bool single = array.ndim() == 0;
  if (array.dtype().kind() != 'b') fail(what, "the dtype is " + dtype_text(array) + ", but must be bool");
  if (!single && (array.ndim() != 1 || static_cast<std::size_t>(array.size()) != count))
    fail(what, "the shape is " + shape_text(array) + ", but must be (" + std::to_string(count) +
                   ",), or one bool for all rows");
  const py::array_t<bool, kInOrder> flags(array);
  std::vector<std::uint8_t> all(count);
  for (std::size_t row = 0; row < count; ++row) all[row] = flags.data()[single ? 0 : row] ? 1 : 0;
  return all;
}

py::array read_only(py::array array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array pair_array(std::span<const Pair> pairs) {
  static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));
  py::array_t<std::uint32_t> array({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::memcpy(array.mutable_data(), pairs.data(), pairs.size_bytes());
  return read_only(std::move(array));
}

py::array id_array(std::span<const ObjectId> ids) {
  py::array_t<std::uint32_t> array(static_cast<py::ssize_t>(ids.size()));
  std::memcpy(array.mutable_data(), ids.data(), ids.size_bytes());
  return read_only(std::move(array));
}

template <int D>
py::array box_array(std::span<const Box<D>> boxes) {
  py::array_t<float> array({static_cast<py::ssize_t>(boxes.size()), py::ssize_t{2}, py::ssize_t{D}});
  std::memcpy(array.mutable_data(), boxes.data(), boxes.size_bytes());
  return array;
}

template class BoxRows<2>;
template class BoxRows<3>;
template py::array box_array<2>(std::span<const Box<2>>);
template py::array box_array<3>(std::span<const Box<3>>);

}  // namespace kerf::python

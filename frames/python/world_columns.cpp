#include "frames/python/world_columns.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "frames/python/arrays.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

constexpr std::array<std::string_view, kObjectKinds> kKinds{"fixed", "kinematic", "moving", "sensor"};

/// A list's numbers stay as they are: numpy makes floats of whole numbers when some of them need all 64 bits.
py::array column_array(const py::handle& given, const std::string& name) {
  if (py::isinstance<py::array>(given)) return as_array(given, name);
  return as_array(py::module_::import("numpy").attr("asarray")(given, "object"), name);
}

/// One value for all rows, or one a row.
class Column {
 public:
  Column(const py::handle& given, std::size_t rows, std::string name)
      : array_(column_array(given, name)), name_(std::move(name)) {
    single_ = array_.ndim() == 0;
    if (!single_ && (array_.ndim() != 1 || static_cast<std::size_t>(array_.shape(0)) != rows))
      throw py::value_error(name_ + ": the shape is " + shape_text(array_) + ", but must be (" +
                            std::to_string(rows) + ",), or one value for all rows");
  }

  /// The whole number of a row, from `least` to `most`.
  template <class Whole>
  [[nodiscard]] Whole whole(std::size_t row, Whole least, Whole most) const {
    const py::object value = element(row);
    py::object number;
    if (PyIndex_Check(value.ptr()) != 0) {
      number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
      if (!number && PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
      PyErr_Clear();
    }
    if (!number || number < py::int_(least) || number > py::int_(most))
      fail(row, "is " + std::string(py::str(value)) + "; it is a whole number from " + std::to_string(least) +
                    " to " + std::to_string(most));
    return number.cast<Whole>();
  }

  [[nodiscard]] float length(std::size_t row) const {
    const py::object value = element(row);
    const double given = PyFloat_AsDouble(value.ptr());  // takes no text
    const auto number = static_cast<float>(given);
    const bool is_number = PyErr_Occurred() == nullptr;
    if (!is_number && PyErr_ExceptionMatches(PyExc_TypeError) == 0 &&
        PyErr_ExceptionMatches(PyExc_OverflowError) == 0)
      throw py::error_already_set();
    PyErr_Clear();
    if (!is_number || !(given >= 0) || std::isinf(number))
      fail(row, "is " + std::string(py::repr(value)) + "; it is a finite number, not negative");
    return number;
  }

 private:
  [[nodiscard]] py::object element(std::size_t row) const {
    return single_ ? array_.attr("item")() : array_.attr("item")(row);
  }
  [[noreturn]] void fail(std::size_t row, const std::string& problem) const {
    throw py::value_error(name_ + ": row " + std::to_string(row) + " " + problem);
  }

  py::array array_;
  std::string name_;
  bool single_ = true;
};

/// A name becomes a number. `where`: the row, for the message.
py::object kind_number(const py::object& given, const std::string& where) {
  if (!py::isinstance<py::str>(given)) return given;
  const auto name = given.cast<std::string>();
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (kKinds[k] == name) return py::int_(k);
  throw py::value_error("kind: " + where + "'" + name +
                        "' is none of 'fixed', 'kinematic', 'moving', 'sensor'");
}

/// The same for one, or for one a row.
py::object kind_numbers(const py::object& given) {
  if (given.is_none()) return given;
  py::array array = column_array(given, "kind");
  const char type = array.dtype().kind();
  if (array.ndim() > 1 || (type != 'O' && type != 'U')) return array;
  const py::object values = array.attr("tolist")();
  if (array.ndim() == 0) return kind_number(values, "");
  py::list numbers;
  for (const py::handle value : values)
    numbers.append(kind_number(py::reinterpret_borrow<py::object>(value),
                               "row " + std::to_string(numbers.size()) + ": "));
  return numbers;
}

template <class Set>
void for_rows(const py::object& given, std::span<ObjectDef> defs, const char* name, Set set) {
  if (given.is_none()) return;
  const Column column(given, defs.size(), name);
  for (std::size_t row = 0; row < defs.size(); ++row) set(defs[row], column, row);
}

}  // namespace

PythonObject to_python(const ObjectDef& def) {
  PythonObject object{};
  object.kind = static_cast<std::uint8_t>(def.kind);
  object.category = def.filter.category;
  object.mask = def.filter.mask;
  object.group = def.filter.group;
  object.margin = def.margin;
  object.user_data = def.user_data;
  return object;
}

void apply_columns(const WorldColumns& columns, std::span<ObjectDef> defs) {
  constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
  constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  for_rows(kind_numbers(columns.kind), defs, "kind",
           [](ObjectDef& def, const Column& column, std::size_t row) {
             def.kind = static_cast<ObjectKind>(column.whole<std::uint64_t>(row, 0, kObjectKinds - 1));
           });
  for_rows(columns.category, defs, "category", [](ObjectDef& def, const Column& column, std::size_t row) {
    def.filter.category = column.whole<std::uint64_t>(row, 0, kAll);
  });
  for_rows(columns.mask, defs, "mask", [](ObjectDef& def, const Column& column, std::size_t row) {
    def.filter.mask = column.whole<std::uint64_t>(row, 0, kAll);
  });
  for_rows(columns.group, defs, "group", [](ObjectDef& def, const Column& column, std::size_t row) {
    def.filter.group = column.whole<std::int32_t>(row, kLeast, kMost);
  });
  for_rows(columns.margin, defs, "margin",
           [](ObjectDef& def, const Column& column, std::size_t row) { def.margin = column.length(row); });
  for_rows(columns.user_data, defs, "user_data", [](ObjectDef& def, const Column& column, std::size_t row) {
    def.user_data = column.whole<std::uint64_t>(row, 0, kAll);
  });
}

}  // namespace kerf::python

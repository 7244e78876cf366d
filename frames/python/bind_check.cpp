#include <pybind11/stl.h>

#include "frames/python/arrays.h"
#include "frames/python/bindings.h"
#include "frames/python/check.h"
#include "frames/python/pickling.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

constexpr const char* kCheck = R"(Compares a broad phase of yours with brute force.

function   takes boxes (n, 2, d), float32 or float64, and returns pairs of rows: (m, 2) whole numbers, or any
           iterable of two each, but no tuple of arrays (np.argwhere(...), not np.nonzero(...)). With stateful=True
           it takes nothing and returns such a function, which then sees the steps in order and may remember them.
boxes      (n, 2, d), (steps, n, 2, d), or a list of (n, 2, d), one for each step. float32 stays float32; all
           other numbers (whole ones, float16) become float64. The function gets a copy, in C order and in the
           machine's byte order
touching   'pair': boxes that touch are a pair, as for Kerf (they are closed); 'none': they are not; 'either':
           both answers are right
shrink     False: the boxes as given, up to the step that fails
raises     True: a failure is raised, as kerf.CheckFailed

Returns None if all pairs are right, else a kerf.CheckFailure with the smallest scene that still fails: without
any one of its boxes (or steps) the function is right, raises, or returns no pairs; .raised says which. The right
answer is computed in float32 or float64, as the function gets the boxes; the order of pairs, and of the two rows
in one, does not matter, but a pair must not come twice. What the function raises for the boxes given is raised.)";

Touching touching_from(const std::string& text) {
  if (text == "pair") return Touching::pair;
  if (text == "none") return Touching::none;
  if (text == "either") return Touching::either;
  throw py::value_error("touching: '" + text + "' is none of 'pair', 'none', 'either'");
}

/// In C order, float32 as it is and everything else as float64, with rows that are boxes.
py::array checkable(const py::array& array, const std::string& what) {
  if (array.ndim() == 1 && array.size() == 0) return py::array_t<double>({0, 2, 2});
  check_box_shape(array, 0, what);
  if (array.shape(2) == 2) {
    (void)BoxRows<2>(array, what);
  } else {
    (void)BoxRows<3>(array, what);
  }
  const bool is_float = array.dtype().kind() == 'f' && array.itemsize() == sizeof(float);
  if (is_float) return py::array_t<float, kInOrder>(array);
  return py::array_t<double, kInOrder>(array);
}

std::vector<py::array> steps_from(const py::object& given) {
  const bool is_list = py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given);
  constexpr const char* kNone = "boxes: there is no step; of a step without boxes give shape (0, 2, 2)";
  if (is_list && py::len(given) == 0) throw py::value_error(kNone);
  const bool of_arrays = is_list && py::isinstance<py::array>(given[py::int_(0)]);
  if (!of_arrays) {
    const py::array array = as_array(given, "boxes");
    if (array.ndim() != 4) return {checkable(array, "boxes")};
    if (array.shape(0) == 0) throw py::value_error(kNone);
  }
  std::vector<py::array> steps;
  for (const auto& step : given)
    steps.push_back(checkable(as_array(step, "boxes"), "boxes: step " + std::to_string(steps.size())));
  return steps;
}

py::object check_boxes(const py::function& function, const py::object& boxes, const std::string& touching,
                       bool stateful, bool shrink, bool raises) {
  auto failure = check(function, steps_from(boxes), {touching_from(touching), stateful, shrink});
  if (!failure) return py::none();
  const std::string text = failure->text();
  py::object result = py::cast(std::move(*failure));
  if (!raises) return result;
  const py::object type = py::module_::import("kerf").attr("CheckFailed");
  const py::object error = type(text);
  error.attr("failure") = result;
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

py::array row_array(const std::vector<RowPair>& pairs) {
  return py::array_t<std::int64_t>({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}},
                                   pairs.empty() ? nullptr : pairs.front().data());
}

}  // namespace

void bind_check(py::module_& module) {
  py::class_<CheckFailure>(module, "CheckFailure",
                           "The smallest scene in which a function's pairs are wrong; str() describes it.")
      .def("__reduce__", refuse_pickling("CheckFailure", kTakeValues))
      .def_readonly("step", &CheckFailure::step,
                    "The step in which they are wrong: an index of the boxes given.")
      .def_readonly("steps", &CheckFailure::steps,
                    "The steps that the function must see for that; the last is step.")
      .def_property_readonly(
          "rows",
          [](const CheckFailure& f) {
            return py::array_t<std::int64_t>(static_cast<py::ssize_t>(f.rows.size()), f.rows.data());
          },
          "Which rows of the boxes given: (k,) int64.")
      .def_property_readonly(
          "boxes", [](const CheckFailure& f) { return f.scene.back(); },
          "The boxes of that step: (k, 2, d), as the function got them.")
      .def_readonly("scene", &CheckFailure::scene, "The boxes of each of steps: a list of (k, 2, d).")
      .def_property_readonly(
          "missed", [](const CheckFailure& f) { return row_array(f.faults.missed); },
          "Pairs of rows of .boxes that overlap and were not reported: (m, 2) int64.")
      .def_property_readonly(
          "invented", [](const CheckFailure& f) { return row_array(f.faults.invented); },
          "Reported, but no overlap, or no rows: (m, 2) int64.")
      .def_property_readonly(
          "doubled", [](const CheckFailure& f) { return row_array(f.faults.doubled); },
          "Reported again, once for each further time: (m, 2) int64.")
      .def_property_readonly(
          "counts",
          [](const CheckFailure& f) {
            return py::make_tuple(f.all.missed.size(), f.all.invented.size(), f.all.doubled.size());
          },
          "How many were missed, invented and doubled in that step of the boxes given.")
      .def_readonly("repeats", &CheckFailure::repeats,
                    "False: the same boxes did not give wrong pairs when they were tried again, so there is "
                    "no smaller scene.")
      .def_readonly("raised", &CheckFailure::raised,
                    "What the function did instead of returning pairs without one of these boxes or steps, "
                    "as 'IndexError: ...': a list of str, each once. Empty: it was right each time, or it "
                    "was not tried (shrink=False). Where .repeats is False: with the same boxes.")
      .def_readonly("calls", &CheckFailure::calls, "How often the function was called.")
      .def_property_readonly("text", &CheckFailure::text)
      .def("__str__", &CheckFailure::text)
      .def("__repr__", [](const CheckFailure& f) {
        return "<kerf.CheckFailure: step " + std::to_string(f.step) + ", " + std::to_string(f.rows.size()) +
               " boxes>";
      });
  module.def("check", &check_boxes, py::arg("function"), py::arg("boxes"), py::kw_only(),
             py::arg("touching") = "pair", py::arg("stateful") = false, py::arg("shrink") = true,
             py::arg("raises") = false, kCheck);
}

}  // namespace kerf::python

#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frames/python/judged_boxes.h"
#include "frames/python/made.h"

namespace kerf::python {

struct CheckOptions {
  Touching touching = Touching::pair;
  /// The function is one without arguments that makes the one to be checked, which then sees all steps of a
  /// scene in order and may remember what it saw.
  bool stateful = false;
  bool shrink = true;  ///< false: the scene as given, up to the step that fails
};

/// `kerf.CheckFailure`: the smallest scene in which a function's pairs are wrong.
struct CheckFailure {
  std::size_t step = 0;            ///< in which they are wrong: an index of the steps given
  std::vector<std::size_t> steps;  ///< the steps that the function must see for that, the last being `step`
  std::vector<std::int64_t> rows;  ///< the rows of the boxes given
  std::vector<pybind11::array> scene;  ///< the boxes of each of `steps`: (k, 2, d), as the function got them
  RowFaults faults;                    ///< in rows of the last of them
  RowFaults all;                       ///< in rows of the step as it was given
  bool repeats = true;  ///< false: the same boxes did not give wrong pairs when they were tried again
  /// What the function did in place of returning pairs, "IndexError: ...", when one of these boxes or steps
  /// was left out; where it does not repeat, when the same boxes were tried again. Each text once.
  std::vector<std::string> raised;
  std::size_t calls = 0;  ///< of the function

  [[nodiscard]] std::string text() const;
};

/// Holds a function of Python's against brute force: `steps` are arrays (n, 2, d) of float32 or float64 in C
/// order, and the function takes such an array and returns pairs of rows. Nothing if all its pairs are right.
///
/// What the function raises for the boxes given leaves through this one; for smaller ones it only means that
/// they are not smaller scenes of the same fault.
std::optional<CheckFailure> check(const pybind11::function& function,
                                  const std::vector<pybind11::array>& steps, const CheckOptions& options);

}  // namespace kerf::python

KERF_CLASS_OF_PYTHON(kerf::python::CheckFailure);

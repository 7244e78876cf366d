#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace kerf::python {

inline constexpr const char* kTakeValues = "take its values instead";

/// The `__reduce__` of a class that can be neither pickled nor copied: a TypeError. Without it, pickle's
/// protocols 0 and 1 make an object of Python's own base class, which ends the process.
inline auto refuse_pickling(const std::string& name, const std::string& instead) {
  return [message = "cannot pickle or copy a kerf." + name + ": " + instead](const pybind11::object&) {
    throw pybind11::type_error(message);
  };
}

}  // namespace kerf::python

#pragma once

#include <pybind11/pybind11.h>

namespace kerf::python {

// Each adds a part of the module.
void bind_broad_phase(pybind11::module_& module);
void bind_recording(pybind11::module_& module);
void bind_check(pybind11::module_& module);
void bind_world(pybind11::module_& module);
void bind_pictures(pybind11::module_& module);

}  // namespace kerf::python

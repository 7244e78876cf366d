#pragma once

#include <pybind11/pybind11.h>

#include "frames/python/broad_phase.h"

namespace kerf::python {

/// Adds the queries to `kerf.BroadPhase`.
void bind_queries(pybind11::class_<PythonBroadPhase>& type);

}  // namespace kerf::python

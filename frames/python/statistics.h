#pragma once

#include <pybind11/pybind11.h>

#include "core/trace/statistics.h"

namespace kerf::python {

/// Names and numbers as `kerf render` writes them into a manifest: counts, `redundancy`, how often each
/// operator acted, and the seconds of each phase of the last step.
pybind11::dict statistics_dict(const Statistics& statistics);

}  // namespace kerf::python

#pragma once

#include <pybind11/numpy.h>

#include "frames/python/picture.h"

namespace kerf::python {

/// Boxes (n, 2, d), and lines for pairs (m, 2) of their rows or None: (height, width, 3) uint8. Throws
/// ValueError for pairs of rows that do not exist.
pybind11::array box_picture(const pybind11::handle& boxes, const pybind11::handle& pairs,
                            const PictureOptions& options);

}  // namespace kerf::python

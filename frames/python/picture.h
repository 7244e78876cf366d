#pragma once

#include <pybind11/numpy.h>

#include "viz/draw/frame_renderer.h"

namespace kerf::python {

/// What a picture shows, and from where.
struct PictureOptions {
  int width = 1280;
  int height = 720;
  std::string layers;  ///< see LayerSet::parse; empty: all
  std::string camera;  ///< see parse_camera
};

/// Throws ValueError for a size, layers or a camera that cannot be.
FrameOptions frame_options(const PictureOptions& options);

/// One moment as a picture of its own, (height, width, 3) uint8; Python's other threads run meanwhile.
template <int D>
pybind11::array draw(const FrameInput<D>& input, const PictureOptions& options);

/// The picture without its alpha: (height, width, 3) uint8.
pybind11::array rgb_array(const Image& image);

}  // namespace kerf::python

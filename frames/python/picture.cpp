#include "frames/python/picture.h"

#include <optional>
#include <string>

#include "frames/sequence/recording_picture.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

void check_side(const char* name, int side) {
  if (side < kMinFrameSide || side > kMaxFrameSide)
    throw py::value_error(std::string(name) + ": it is " + std::to_string(side) + ", but must be " +
                          std::to_string(kMinFrameSide) + " to " + std::to_string(kMaxFrameSide) + " pixels");
}

}  // namespace

FrameOptions frame_options(const PictureOptions& options) {
  check_side("width", options.width);
  check_side("height", options.height);
  FrameOptions frame;
  frame.width = options.width;
  frame.height = options.height;
  frame.layers = options.layers.empty() ? kRecordedLayers : LayerSet::parse(options.layers, kRecordedLayers);
  frame.camera = options.camera;
  return frame;
}

template <int D>
py::array draw(const FrameInput<D>& input, const PictureOptions& options) {
  const FrameOptions frame = frame_options(options);
  std::optional<FrameRenderer<D>> renderer;  // the picture is its own
  const Image* const image = [&] {
    const py::gil_scoped_release others_run;
    renderer.emplace(frame);
    return &renderer->render(input);
  }();
  return rgb_array(*image);
}

template py::array draw(const FrameInput<2>&, const PictureOptions&);
template py::array draw(const FrameInput<3>&, const PictureOptions&);

py::array rgb_array(const Image& image) {
  py::array_t<std::uint8_t> array({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{3}});
  std::uint8_t* to = array.mutable_data();
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    for (std::size_t channel = 0; channel < 3; ++channel) *to++ = image.rgba[k + channel];
  return array;
}

}  // namespace kerf::python

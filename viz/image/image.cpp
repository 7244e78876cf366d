#include "viz/image/image.h"

#include <stdexcept>
#include <string>

namespace kerf {

Image make_image(int width, int height, std::uint32_t rgba) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("an image cannot be " + std::to_string(width) + "x" + std::to_string(height) +
                                " pixels");
  }
  Image image{width, height, {}};
  image.rgba.resize(image.stride() * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = static_cast<std::uint8_t>(rgba >> (24U - 8U * (i % 4U)));
  return image;
}

}  // namespace kerf

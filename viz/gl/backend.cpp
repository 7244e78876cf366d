#include "viz/gl/backend.h"

#include <array>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

constexpr std::array<std::string_view, 3> kBackendNames{"any", "osmesa", "egl"};

}  // namespace

std::string_view to_string(GlBackend backend) { return kBackendNames[static_cast<std::size_t>(backend)]; }

GlBackend parse_gl_backend(std::string_view text) {
  for (const GlBackend backend : {GlBackend::any, GlBackend::osmesa, GlBackend::egl})
    if (text == to_string(backend)) return backend;
  throw std::invalid_argument("there is no backend '" + std::string(text) + "'; give any, osmesa or egl");
}

}  // namespace kerf

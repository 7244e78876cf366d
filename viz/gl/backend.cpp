#include "viz/gl/backend.h"

#include <stdexcept>
#include <string>

namespace kerf {

std::string_view to_string(GlBackend backend) { return backend == GlBackend::egl ? "egl" : "osmesa"; }

GlBackend parse_gl_backend(std::string_view text) {
  for (const GlBackend backend : {GlBackend::osmesa, GlBackend::egl})
    if (text == to_string(backend)) return backend;
  throw std::invalid_argument("there is no backend '" + std::string(text) + "'; give osmesa or egl");
}

}  // namespace kerf

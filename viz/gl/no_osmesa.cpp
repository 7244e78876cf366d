// A program built where OSMesa's header is missing, as it is with Mesa after 25.0.

#include <stdexcept>

#include "viz/gl/context.h"

namespace kerf {

bool has_osmesa() { return false; }

std::unique_ptr<GlContext> make_osmesa_context() {
  throw std::runtime_error("OSMesa: this program was built without it; draw with --backend egl");
}

}  // namespace kerf

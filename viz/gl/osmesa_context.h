#pragma once

#include <memory>

#include "viz/gl/context.h"

namespace kerf {

/// Whether its library can be loaded.
bool has_osmesa();

/// Mesa's software rasteriser without a window system. Mesa dropped it after 25.0.
std::unique_ptr<GlContext> make_osmesa_context();

}  // namespace kerf

#pragma once

#include <memory>

#include "viz/gl/context.h"

namespace kerf {

/// Mesa's EGL without a surface, by its software rasteriser unless LIBGL_ALWAYS_SOFTWARE says otherwise.
/// libEGL is loaded at the first call. Throws std::runtime_error that says what is missing.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace kerf

#pragma once

#include <memory>

#include "viz/gl/context.h"

namespace kerf {

/// EGL without a surface, of Mesa, by its software rasteriser unless LIBGL_ALWAYS_SOFTWARE says otherwise.
/// libEGL is loaded when it is asked for. Throws std::runtime_error that says what is missing.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace kerf

#pragma once

#include "viz/gl/functions.h"

namespace kerf {

/// Compiles a stage of a shader program: the caller owns it. Throws std::runtime_error with the driver's
/// message.
GLuint compile_shader(const GlFunctions& gl, GLenum type, const char* source);

}  // namespace kerf

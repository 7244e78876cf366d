#include "viz/gl/functions.h"

#include <stdexcept>
#include <string>

namespace kerf {

GlFunctions load_gl_functions(GlProcedure (*find)(const char* name)) {
  GlFunctions gl;
#define KERF_GL_LOAD(TYPE, NAME) gl.NAME = reinterpret_cast<PFNGL##TYPE##PROC>(find("gl" #NAME));
  KERF_GL_FUNCTIONS(KERF_GL_LOAD)
#undef KERF_GL_LOAD
  if (gl.GetString == nullptr || gl.GetIntegerv == nullptr)
    throw std::runtime_error("OpenGL cannot be loaded");
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (10 * major + minor < 33) {
    throw std::runtime_error("OpenGL 3.3 is needed, this driver has " + std::to_string(major) + "." +
                             std::to_string(minor));
  }
#define KERF_GL_CHECK(TYPE, NAME) \
  if (gl.NAME == nullptr) throw std::runtime_error("OpenGL 3.3 without gl" #NAME ": a broken driver");
  KERF_GL_FUNCTIONS(KERF_GL_CHECK)
#undef KERF_GL_CHECK
  return gl;
}

void check_gl(const GlFunctions& gl, std::string_view where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  std::string name = std::to_string(error);
  if (error == GL_INVALID_ENUM) name = "GL_INVALID_ENUM";
  if (error == GL_INVALID_VALUE) name = "GL_INVALID_VALUE";
  if (error == GL_INVALID_OPERATION) name = "GL_INVALID_OPERATION";
  if (error == GL_INVALID_FRAMEBUFFER_OPERATION) name = "GL_INVALID_FRAMEBUFFER_OPERATION";
  if (error == GL_OUT_OF_MEMORY) name = "GL_OUT_OF_MEMORY";
  throw std::runtime_error("OpenGL error in " + std::string(where) + ": " + name);
}

}  // namespace kerf

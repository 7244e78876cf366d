#include "viz/gl/context.h"

#include <malloc.h>

#include <cstdlib>

namespace kerf {

/// With vectors of 256 bits llvmpipe drew one pixel of the references differently on processors of Intel and
/// AMD; with 128 it draws them all alike. It reads the variable when a process makes its first context.
std::unique_ptr<GlContext> make_offscreen_context(GlBackend backend) {
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
  if (backend == GlBackend::egl || (backend == GlBackend::any && !has_osmesa())) return make_egl_context();
  return make_osmesa_context();
}

std::string GlContext::rasterizer() const {
  const auto text = [this](GLenum what) {
    return std::string(reinterpret_cast<const char*>(functions().GetString(what)));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void tune_allocator_for_rendering() {
  constexpr int kKeep = 256 << 20;
  mallopt(M_TRIM_THRESHOLD, kKeep);
  mallopt(M_TOP_PAD, 16 << 20);
  mallopt(M_MMAP_THRESHOLD, kKeep);
}

}  // namespace kerf

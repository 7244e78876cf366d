#pragma once

#include <memory>
#include <string>

#include "viz/gl/backend.h"
#include "viz/gl/functions.h"

namespace kerf {

/// An OpenGL 3.3 core context of any backend. Drawings go into our own framebuffer objects, never into the
/// context's default one.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  /// Makes it the calling thread's context. Throws std::runtime_error if the driver refuses.
  virtual void make_current() = 0;
  [[nodiscard]] virtual const GlFunctions& functions() const = 0;
  /// Driver and version, for reports.
  [[nodiscard]] virtual std::string description() const = 0;
  /// The rasteriser and its version, which decide the pixels whatever the backend.
  [[nodiscard]] std::string rasterizer() const;
};

/// A context without window or display, current in the calling thread. Throws std::runtime_error that says
/// what is missing. A process that forks must do so before the first context.
std::unique_ptr<GlContext> make_offscreen_context(GlBackend backend = GlBackend::any);

/// Makes malloc keep the memory that the software rasteriser frees each frame (up to a fifth faster). It
/// affects the whole process, so programs call it, libraries do not.
void tune_allocator_for_rendering();

}  // namespace kerf

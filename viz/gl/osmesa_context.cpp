#include "viz/gl/osmesa_context.h"

#include <GL/osmesa.h>  // after glcorearb.h, which would leave out half of its types

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() : context_(OSMesaCreateContextAttribs(kAttributes.data(), nullptr)) {
    if (context_ == nullptr) throw std::runtime_error("OSMesa cannot make an OpenGL 3.3 core context");
    try {
      make_current();
      functions_ = load_gl_functions(&OSMesaGetProcAddress);
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  void make_current() override {
    if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_FALSE)
      throw std::runtime_error("OSMesa refuses its context");
  }

  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }

  [[nodiscard]] std::string description() const override { return "OSMesa, " + rasterizer(); }

 private:
  static constexpr std::array<int, 11> kAttributes{OSMESA_FORMAT,
                                                   OSMESA_RGBA,
                                                   OSMESA_PROFILE,
                                                   OSMESA_CORE_PROFILE,
                                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                                   3,
                                                   OSMESA_CONTEXT_MINOR_VERSION,
                                                   3,
                                                   0,
                                                   0,
                                                   0};
  // OSMesa wants a window buffer to be current; nothing is drawn into it.
  static constexpr int kSide = 4;
  std::array<std::uint8_t, 4 * kSide * kSide> buffer_{};
  OSMesaContext context_;
  GlFunctions functions_;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace kerf

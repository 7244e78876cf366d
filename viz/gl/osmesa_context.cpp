#include <GL/glcorearb.h>
#include <GL/osmesa.h>  // after glcorearb.h, which would otherwise leave out half of its types
#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "viz/gl/context.h"

namespace kerf {
namespace {

[[noreturn]] void fail_osmesa(const std::string& what) {
  throw std::runtime_error(
      "OSMesa: " + what + "; draw with --backend egl, or install it (on Debian: apt-get install libosmesa6)");
}

/// libOSMesa, loaded at the first drawing and for the rest of the process; null if it cannot be loaded. It is
/// not linked, because it brings a compiler that takes longer to load than most commands of the program take,
/// and a GL of its own.
void* osmesa_library() {
  static void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  return library;
}

struct OsmesaLibrary {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) set_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;

  OsmesaLibrary() {
    if (osmesa_library() == nullptr) fail_osmesa("libOSMesa.so.8 cannot be loaded");
    load(create_context, "OSMesaCreateContextAttribs");
    load(destroy_context, "OSMesaDestroyContext");
    load(set_current, "OSMesaMakeCurrent");
    load(get_proc_address, "OSMesaGetProcAddress");
  }

 private:
  template <class Function>
  void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(osmesa_library(), name));
    if (function == nullptr) fail_osmesa(std::string("it has no ") + name);
  }
};

const OsmesaLibrary& osmesa() {
  static const OsmesaLibrary library;
  return library;
}

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() : context_(osmesa().create_context(kAttributes.data(), nullptr)) {
    if (context_ == nullptr) fail_osmesa("it cannot make an OpenGL 3.3 core context");
    try {
      make_current();
      functions_ = load_gl_functions(osmesa().get_proc_address);
    } catch (...) {
      osmesa().destroy_context(context_);
      throw;
    }
  }
  ~OsmesaContext() override { osmesa().destroy_context(context_); }

  void make_current() override {
    if (osmesa().set_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_FALSE)
      fail_osmesa("it refuses its context");
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
  // OSMesa needs a window buffer to be current; nothing is drawn into it.
  static constexpr int kSide = 4;
  std::array<std::uint8_t, 4 * kSide * kSide> buffer_{};
  OSMesaContext context_;
  GlFunctions functions_;
};

}  // namespace

bool has_osmesa() { return osmesa_library() != nullptr; }

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace kerf

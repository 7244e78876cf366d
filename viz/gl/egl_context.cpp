#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "viz/gl/context.h"

namespace kerf {
namespace {

[[noreturn]] void fail_egl(const std::string& what) {
  throw std::runtime_error("EGL: " + what +
                           "; draw with --backend osmesa, or install Mesa's EGL (on Debian: apt-get install "
                           "libegl1 libegl-mesa0)");
}

/// libEGL, loaded for the rest of the process: its drivers do not survive unloading. It is not linked, so
/// that its GL and OSMesa's stay apart, and a machine without it has the rest.
struct EglLibrary {
  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC set_current = nullptr;

  EglLibrary() {
    void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) fail_egl("libEGL.so.1 cannot be loaded");
    get_proc_address = reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(library, "eglGetProcAddress"));
    if (get_proc_address == nullptr) fail_egl("libEGL.so.1 has no eglGetProcAddress");
    load(get_platform_display, "eglGetPlatformDisplayEXT");
    load(initialize, "eglInitialize");
    load(bind_api, "eglBindAPI");
    load(choose_config, "eglChooseConfig");
    load(create_context, "eglCreateContext");
    load(destroy_context, "eglDestroyContext");
    load(set_current, "eglMakeCurrent");
  }

 private:
  template <class Function>
  void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(get_proc_address(name));
    if (function == nullptr) fail_egl(std::string("it has no ") + name);
  }
};

const EglLibrary& egl() {
  static const EglLibrary library;
  return library;
}

GlProcedure find_gl(const char* name) { return egl().get_proc_address(name); }

class EglContext final : public GlContext {
 public:
  EglContext() {
    // The pixels must be OSMesa's; a graphics card's are not.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    display_ = egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || egl().initialize(display_, nullptr, nullptr) == EGL_FALSE)
      fail_egl("it knows no display without a surface");
    try {
      context_ = create();
      make_current();
      functions_ = load_gl_functions(&find_gl);
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~EglContext() override { destroy(); }

  /// Without the release EGL would believe that its context is current while OSMesa's is.
  void make_current() override {
    egl().set_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl().set_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      fail_egl("it refuses its context");
  }

  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] std::string description() const override { return "EGL, " + rasterizer(); }

 private:
  [[nodiscard]] EGLContext create() const {
    constexpr std::array kConfig{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
    constexpr std::array kContext{EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    egl().bind_api(EGL_OPENGL_API);
    if (egl().choose_config(display_, kConfig.data(), &config, 1, &found) == EGL_FALSE || found < 1)
      fail_egl("it has no configuration for OpenGL");
    EGLContext context = egl().create_context(display_, config, EGL_NO_CONTEXT, kContext.data());
    if (context == EGL_NO_CONTEXT) fail_egl("it cannot make an OpenGL 3.3 core context");
    return context;
  }

  /// The display is shared by all contexts of the process and stays.
  void destroy() const {
    egl().set_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl().destroy_context(display_, context_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  GlFunctions functions_;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace kerf

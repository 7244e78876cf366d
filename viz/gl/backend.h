#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace kerf {

class GlContext;

/// How to draw without window or display. All give the same pixels; `any` is OSMesa, or EGL where OSMesa is
/// missing.
enum class GlBackend : std::uint8_t { any, osmesa, egl };
std::string_view to_string(GlBackend backend);
/// Throws std::invalid_argument that lists the names.
GlBackend parse_gl_backend(std::string_view text);

/// Whether the library of OSMesa can be loaded.
bool has_osmesa();
/// Mesa's software rasteriser without a window system. Mesa dropped it after 25.0.
std::unique_ptr<GlContext> make_osmesa_context();
/// Mesa's EGL without a surface, by its software rasteriser unless LIBGL_ALWAYS_SOFTWARE says otherwise.
/// libEGL is loaded at the first call. Throws std::runtime_error that says what is missing.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace kerf

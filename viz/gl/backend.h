#pragma once

#include <cstdint>
#include <string_view>

namespace kerf {

/// How to draw without window or display. All give the same pixels; `any` is OSMesa, or EGL where OSMesa is
/// missing.
enum class GlBackend : std::uint8_t { any, osmesa, egl };
std::string_view to_string(GlBackend backend);
/// Throws std::invalid_argument that lists the names.
GlBackend parse_gl_backend(std::string_view text);

}  // namespace kerf

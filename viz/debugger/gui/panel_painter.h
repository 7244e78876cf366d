#pragma once

#include "viz/gl/functions.h"

struct ImDrawData;

namespace kerf {

/// A picture of that many pixels, in which a unit of the panels is `scale` pixels.
struct PanelPicture {
  int width = 0;
  int height = 0;
  float scale = 1;
};

/// A rectangle of the picture in pixels, y down.
struct PixelArea {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Draws the layout of Dear ImGui through the one table of GL functions: the packaged backends have a loader
/// of their own, which finds no libGL under OSMesa. Its context must be current in every call and when it
/// dies.
class PanelPainter {
 public:
  /// Takes the typeface's picture from the current ImGui context.
  explicit PanelPainter(const GlFunctions& gl);
  ~PanelPainter();
  PanelPainter(const PanelPainter&) = delete;
  PanelPainter& operator=(const PanelPainter&) = delete;

  /// Takes it again, since it has changed.
  void take_typeface() const;
  /// Draws what lies within `part` into the bound framebuffer; row 0 is the top.
  void draw(const ImDrawData& data, const PanelPicture& picture, const PixelArea& part) const;

 private:
  void make_program();
  void make_vertex_array();
  void make_texture();

  const GlFunctions& gl_;
  GLuint program_ = 0;
  GLuint vertex_array_ = 0;
  GLuint buffers_[2]{};  ///< corners, indices
  GLuint texture_ = 0;
  GLint picture_size_ = -1;
  GLint pixels_ = -1;  ///< in a unit, if letters lie on whole pixels; else 0
  GLint blank_ = -1;   ///< the texel of what is no letter
};

}  // namespace kerf

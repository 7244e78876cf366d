#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "viz/draw/batch.h"
#include "viz/draw/camera.h"
#include "viz/draw/draw_list.h"
#include "viz/draw/font.h"
#include "viz/gl/functions.h"

namespace kerf {

/// How a batch takes part in hiding.
enum class Depth { ignore, test, test_and_write };

/// How a batch's colours meet those that are there.
enum class Blend {
  over,     ///< by their opacity
  replace,  ///< as if all were opaque, which takes less time
  darken,   ///< the darker of both stays, whatever comes first
};

/// Letters to be drawn, as rectangles of the font's texture on the picture.
struct TextBatch {
  struct Vertex {
    float x, y, u, v;
    Color color;
  };
  std::vector<Vertex> vertices;  ///< six a letter
  std::vector<DrawnText> lines;  ///< if kept: the text written
  bool keeps_lines = false;

  void clear() {
    vertices.clear();
    lines.clear();
  }
  /// Writes one line of UTF-8 with its upper left corner at (x, y), in whole pixels.
  void add(const Font& font, int x, int y, std::string_view text, Color color);
};

/// The GL side of drawing: two programs, one buffer, one texture. Its context must be current in every call
/// and when it dies.
class Painter {
 public:
  Painter(const GlFunctions& gl, const Font& font);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  void begin(Color ground);
  /// Begins a picture in which the last triangle of a pixel wins, with its colour kept bit for bit.
  void begin_ids();
  void draw(const Batch& batch, Depth depth, Blend blend = Blend::over) const;
  void draw(const TextBatch& text, const View& view) const;

 private:
  [[nodiscard]] GLuint make_program(const char* vertex_source, const char* fragment_source) const;
  void set_blending(bool wanted) const;
  void make_vertex_arrays();
  void make_texture(const Font& font);

  const GlFunctions& gl_;
  GLuint shape_program_ = 0;
  GLuint text_program_ = 0;
  std::array<GLuint, 2> vertex_arrays_{};  ///< shapes, text
  std::array<GLuint, 3> buffers_{};        ///< shape corners, shape indices, text corners
  GLuint texture_ = 0;
  GLint picture_size_ = -1;
  bool blends_ = true;  ///< in this picture
};

}  // namespace kerf

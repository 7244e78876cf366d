#include "viz/draw/painter.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "viz/draw/letters.h"
#include "viz/gl/shader.h"

namespace kerf {
namespace {

constexpr const char* kShapeVertex = R"(#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
flat out vec4 face_color;
void main() { gl_Position = position; face_color = color; })";

constexpr const char* kShapeFragment = R"(#version 330 core
flat in vec4 face_color;
out vec4 result;
void main() { result = face_color; })";

constexpr const char* kTextVertex = R"(#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
uniform vec2 picture_size;
flat out vec4 letter_color;
out vec2 texel;
void main() {
  gl_Position = vec4(2.0 * position.xy / picture_size - 1.0, 0.0, 1.0);
  letter_color = color;
  texel = position.zw;
})";

// Letters lie on whole pixels, so the texel of a pixel is fetched, never filtered.
constexpr const char* kTextFragment = R"(#version 330 core
uniform sampler2D letters;
flat in vec4 letter_color;
in vec2 texel;
out vec4 result;
void main() {
  float coverage = texelFetch(letters, ivec2(floor(texel)), 0).r;
  result = vec4(letter_color.rgb, letter_color.a * coverage);
})";

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class T>
GLsizeiptr size_of(const std::vector<T>& values) {
  return static_cast<GLsizeiptr>(values.size() * sizeof(T));
}

}  // namespace

void TextBatch::add(const Font& font, int x, int y, std::string_view text, Color color) {
  if (keeps_lines && !text.empty()) lines.push_back({x, y, std::string(text)});
  int pen = x;
  for (const char32_t code : decode_utf8(text)) {
    const Font::Glyph& glyph = font.glyph(code);
    const auto corner = [&](int dx, int dy) {
      vertices.push_back({static_cast<float>(pen + glyph.dx + dx),
                          static_cast<float>(y + font.ascent() + glyph.dy + dy),
                          static_cast<float>(glyph.left + dx), static_cast<float>(glyph.top + dy), color});
    };
    if (glyph.width > 0 && glyph.height > 0) {
      corner(0, 0);
      corner(glyph.width, 0);
      corner(glyph.width, glyph.height);
      corner(0, 0);
      corner(glyph.width, glyph.height);
      corner(0, glyph.height);
    }
    pen += font.advance();
  }
}

Painter::Painter(const GlFunctions& gl, const Font& font) : gl_(gl) {
  shape_program_ = make_program(kShapeVertex, kShapeFragment);
  text_program_ = make_program(kTextVertex, kTextFragment);
  picture_size_ = gl.GetUniformLocation(text_program_, "picture_size");
  make_vertex_arrays();
  make_texture(font);
  check_gl(gl, "preparing to draw");
}

Painter::~Painter() {
  gl_.DeleteTextures(1, &texture_);
  gl_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  gl_.DeleteVertexArrays(static_cast<GLsizei>(vertex_arrays_.size()), vertex_arrays_.data());
  gl_.DeleteProgram(text_program_);
  gl_.DeleteProgram(shape_program_);
}

GLuint Painter::make_program(const char* vertex_source, const char* fragment_source) const {
  const GLuint vertex = compile_shader(gl_, GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compile_shader(gl_, GL_FRAGMENT_SHADER, fragment_source);
  const GLuint program = gl_.CreateProgram();
  gl_.AttachShader(program, vertex);
  gl_.AttachShader(program, fragment);
  gl_.LinkProgram(program);
  gl_.DeleteShader(vertex);
  gl_.DeleteShader(fragment);
  GLint good = 0;
  gl_.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good != 0) return program;
  std::string log(1024, '\0');
  gl_.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw std::runtime_error("a shader program does not link: " + std::string(log.c_str()));
}

void Painter::make_vertex_arrays() {
  gl_.GenVertexArrays(static_cast<GLsizei>(vertex_arrays_.size()), vertex_arrays_.data());
  gl_.GenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  const auto layout = [this](GLsizei stride, std::size_t color) {
    gl_.EnableVertexAttribArray(0);
    gl_.EnableVertexAttribArray(1);
    gl_.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, offset(0));
    gl_.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(color));
  };
  gl_.BindVertexArray(vertex_arrays_[0]);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  layout(sizeof(Vertex), offsetof(Vertex, color));
  gl_.BindVertexArray(vertex_arrays_[1]);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
  layout(sizeof(TextBatch::Vertex), offsetof(TextBatch::Vertex, color));
}

void Painter::make_texture(const Font& font) {
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, font.texture_width(), font.texture_height(), 0, GL_RED,
                 GL_UNSIGNED_BYTE, font.texture().data());
}

void Painter::begin(Color ground) {
  blends_ = true;
  gl_.DepthMask(GL_TRUE);
  gl_.ClearColor(static_cast<float>(ground.r) / 255.0F, static_cast<float>(ground.g) / 255.0F,
                 static_cast<float>(ground.b) / 255.0F, 1.0F);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);  // the picture stays opaque
}

void Painter::begin_ids() {
  begin({0, 0, 0, 0});
  blends_ = false;
}

void Painter::set_blending(bool wanted) const {
  if (wanted && blends_) {
    gl_.Enable(GL_BLEND);
  } else {
    gl_.Disable(GL_BLEND);
  }
}

void Painter::draw(const Batch& batch, Depth depth, Blend blend) const {
  if (batch.empty()) return;
  if (depth == Depth::ignore) {
    gl_.Disable(GL_DEPTH_TEST);
  } else {
    gl_.Enable(GL_DEPTH_TEST);
  }
  gl_.DepthFunc(GL_LEQUAL);
  gl_.DepthMask(depth == Depth::test_and_write ? GL_TRUE : GL_FALSE);
  set_blending(blend != Blend::replace);
  gl_.BlendEquation(blend == Blend::darken ? GL_MIN : GL_FUNC_ADD);
  gl_.UseProgram(shape_program_);
  gl_.BindVertexArray(vertex_arrays_[0]);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BufferData(GL_ARRAY_BUFFER, size_of(batch.vertices), batch.vertices.data(), GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, size_of(batch.indices), batch.indices.data(), GL_STREAM_DRAW);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void Painter::draw(const TextBatch& text, const View& view) const {
  if (text.vertices.empty()) return;
  gl_.Disable(GL_DEPTH_TEST);
  set_blending(true);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.UseProgram(text_program_);
  gl_.Uniform2f(picture_size_, static_cast<float>(view.picture_width),
                static_cast<float>(view.picture_height));
  gl_.BindTexture(GL_TEXTURE_2D, texture_);  // the context may be shared with others that draw
  gl_.BindVertexArray(vertex_arrays_[1]);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
  gl_.BufferData(GL_ARRAY_BUFFER, size_of(text.vertices), text.vertices.data(), GL_STREAM_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(text.vertices.size()));
}

}  // namespace kerf

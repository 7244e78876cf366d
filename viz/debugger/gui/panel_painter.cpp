#include "viz/debugger/gui/panel_painter.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "viz/gl/shader.h"

namespace kerf {
namespace {

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 color;
uniform vec2 picture_size;
uniform vec2 pixels;
uniform vec2 blank;
out vec2 corner_texel;
out vec4 corner_color;
void main() {
  vec2 place = position;
  if (pixels.x > 0.0 && texel != blank) place = floor(position * pixels + 0.5) / pixels;
  gl_Position = vec4(2.0 * place / picture_size - 1.0, 0.0, 1.0);
  corner_texel = texel;
  corner_color = color;
})";

constexpr const char* kFragment = R"(#version 330 core
uniform sampler2D picture;
in vec2 corner_texel;
in vec4 corner_color;
out vec4 result;
void main() { result = corner_color * texture(picture, corner_texel); })";

ImVec4 in_pixels(const ImVec4& clip, float scale) {
  return {std::floor(clip.x * scale), std::floor(clip.y * scale), std::ceil(clip.z * scale),
          std::ceil(clip.w * scale)};
}

ImVec4 common_part(const ImVec4& clip, const PixelArea& part) {
  return {std::max(clip.x, static_cast<float>(part.x)), std::max(clip.y, static_cast<float>(part.y)),
          std::min(clip.z, static_cast<float>(part.x + part.width)),
          std::min(clip.w, static_cast<float>(part.y + part.height))};
}

const void* bytes_in(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

PanelPainter::PanelPainter(const GlFunctions& gl) : gl_(gl) {
  make_program();
  make_vertex_array();
  make_texture();
  check_gl(gl, "preparing to draw panels");
}

PanelPainter::~PanelPainter() {
  gl_.DeleteTextures(1, &texture_);
  gl_.DeleteBuffers(2, buffers_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteProgram(program_);
}

void PanelPainter::make_program() {
  const GLuint vertex = compile_shader(gl_, GL_VERTEX_SHADER, kVertex);
  const GLuint fragment = compile_shader(gl_, GL_FRAGMENT_SHADER, kFragment);
  program_ = gl_.CreateProgram();
  gl_.AttachShader(program_, vertex);
  gl_.AttachShader(program_, fragment);
  gl_.LinkProgram(program_);
  gl_.DeleteShader(vertex);
  gl_.DeleteShader(fragment);
  picture_size_ = gl_.GetUniformLocation(program_, "picture_size");
  pixels_ = gl_.GetUniformLocation(program_, "pixels");
  blank_ = gl_.GetUniformLocation(program_, "blank");
}

void PanelPainter::make_vertex_array() {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(2, buffers_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  for (const GLuint attribute : {0U, 1U, 2U}) gl_.EnableVertexAttribArray(attribute);
  constexpr GLsizei kStride = sizeof(ImDrawVert);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, bytes_in(offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, bytes_in(offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, bytes_in(offsetof(ImDrawVert, col)));
}

void PanelPainter::make_texture() {
  gl_.GenTextures(1, &texture_);
  take_typeface();
}

void PanelPainter::take_typeface() const {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  fonts.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_)));
}

void PanelPainter::draw(const ImDrawData& data, const PanelPicture& picture, const PixelArea& part) const {
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  gl_.UseProgram(program_);
  const float scale = picture.scale;
  gl_.Uniform2f(picture_size_, static_cast<float>(picture.width) / scale,
                static_cast<float>(picture.height) / scale);
  const ImVec2 blank = ImGui::GetIO().Fonts->TexUvWhitePixel;
  const float snapped = scale == std::round(scale) ? 0 : scale;
  gl_.Uniform2f(pixels_, snapped, snapped);
  gl_.Uniform2f(blank_, blank.x, blank.y);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (int k = 0; k < data.CmdListsCount; ++k) {
    const ImDrawList& list = *data.CmdLists[k];
    gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                   GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4 clip = common_part(in_pixels(command.ClipRect, scale), part);
      if (clip.z <= clip.x || clip.w <= clip.y) continue;
      gl_.Scissor(static_cast<GLint>(clip.x), static_cast<GLint>(clip.y),
                  static_cast<GLsizei>(clip.z - clip.x), static_cast<GLsizei>(clip.w - clip.y));
      gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                                 bytes_in(command.IdxOffset * sizeof(ImDrawIdx)),
                                 static_cast<GLint>(command.VtxOffset));
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace kerf

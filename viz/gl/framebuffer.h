#pragma once

#include "viz/gl/functions.h"
#include "viz/image/image.h"

namespace kerf {

/// The target of a frame: colour and depth with one or several samples a pixel, resolved to one when read.
/// Its context must be current in every call and when it dies.
class Framebuffer {
 public:
  /// Throws std::runtime_error if the driver cannot make it.
  Framebuffer(const GlFunctions& gl, int width, int height, int samples);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Directs drawing here and covers all of it.
  void bind() const;
  /// Copies the picture; row 0 of the buffer becomes the top row.
  void read(Image& image) const;
  /// Copies all of it into another one, its top left corner to (x, y); several samples become one.
  void copy_to(const Framebuffer& target, int x, int y) const;
  /// Copies all of it, upside down as windows have it, into the framebuffer that a window shows.
  void show_in_window(int window_width, int window_height) const;

 private:
  void attach(GLenum point, GLuint renderbuffer, GLenum format, int samples) const;

  const GlFunctions& gl_;
  int width_;
  int height_;
  int samples_;
  GLuint framebuffers_[2]{};   ///< drawn to, read from
  GLuint renderbuffers_[3]{};  ///< colour, depth, resolved colour
};

}  // namespace kerf

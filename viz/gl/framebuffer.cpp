#include "viz/gl/framebuffer.h"

#include <stdexcept>
#include <string>

namespace kerf {

Framebuffer::Framebuffer(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl), width_(width), height_(height), samples_(samples) {
  gl.GenFramebuffers(2, framebuffers_);
  gl.GenRenderbuffers(3, renderbuffers_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
  attach(GL_COLOR_ATTACHMENT0, renderbuffers_[2], GL_RGBA8, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  attach(GL_COLOR_ATTACHMENT0, renderbuffers_[0], GL_RGBA8, samples > 1 ? samples : 0);
  attach(GL_DEPTH_ATTACHMENT, renderbuffers_[1], GL_DEPTH_COMPONENT24, samples > 1 ? samples : 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL cannot make a framebuffer of " + std::to_string(width) + "x" +
                             std::to_string(height) + " pixels");
  }
}

Framebuffer::~Framebuffer() {
  gl_.DeleteFramebuffers(2, framebuffers_);
  gl_.DeleteRenderbuffers(3, renderbuffers_);
}

void Framebuffer::attach(GLenum point, GLuint renderbuffer, GLenum format, int samples) const {
  gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
}

void Framebuffer::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  gl_.Viewport(0, 0, width_, height_);
}

void Framebuffer::copy_to(const Framebuffer& target, int x, int y) const {
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffers_[0]);
  gl_.BlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::show_in_window(int window_width, int window_height) const {
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, window_height, window_width, 0, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

void Framebuffer::read(Image& image) const {
  image.width = width_;
  image.height = height_;
  image.rgba.resize(image.stride() * static_cast<std::size_t>(height_));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  if (samples_ > 1) {
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
  }
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
}

}  // namespace kerf

#pragma once

#include <memory>
#include <string>

#include "viz/debugger/gui/input.h"
#include "viz/gl/context.h"

struct GLFWwindow;

namespace kerf {

/// A window on the user's display with a GL context of its own, and what is done with mouse and keys in it.
class GlfwWindow final : public GlContext {
 public:
  /// Throws std::runtime_error that says why there can be no window: no display, no OpenGL 3.3.
  GlfwWindow(const std::string& title, int width, int height);
  ~GlfwWindow() override;

  void make_current() override;
  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] std::string description() const override;

  /// Pixels of what can be drawn.
  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  [[nodiscard]] bool should_close() const;
  /// Shows what was drawn into the window's framebuffer, and waits for the display.
  void swap();
  /// To be called now and then in long work: shows `progress` as title, answers the display, and is false
  /// once the user has pressed Escape or closes the window.
  [[nodiscard]] bool goes_on(const std::string& progress);
  /// What happened since the last call; `idle`: waits a little for something to happen.
  [[nodiscard]] DebuggerInput take_input(bool idle);

 private:
  /// GLFW is there once for the process, as long as a window lives.
  struct Library {
    Library();
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Close {
    void operator()(GLFWwindow* window) const;
  };
  static GLFWwindow* make_window(const std::string& title, int width, int height);
  void listen();

  Library library_;
  std::unique_ptr<GLFWwindow, Close> window_;
  std::string title_;
  bool is_busy_ = false;  ///< another title is shown
  GlFunctions functions_;
  DebuggerInput input_;  ///< gathered by the callbacks
  double last_ = 0;      ///< time of the last frame in seconds
};

}  // namespace kerf

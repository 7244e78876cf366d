#pragma once

#include <array>
#include <memory>
#include <string>

#include "viz/debugger/gui/input.h"
#include "viz/debugger/gui/input_queue.h"
#include "viz/gl/context.h"

struct GLFWcursor;
struct GLFWwindow;

namespace kerf {

/// A window on the user's display with a GL context of its own, and its mouse and keys.
class GlfwWindow final : public GlContext {
 public:
  /// Throws std::runtime_error that says why there is no window: no display, no OpenGL 3.3.
  /// `grows`: larger by the content scale of its display.
  GlfwWindow(const std::string& title, int width, int height, bool grows = false);
  ~GlfwWindow() override;

  /// Opens a window that is not shown; its description. Throws as the constructor does.
  static std::string try_out();

  void make_current() override;
  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] std::string description() const override;

  /// The size of the drawable area in pixels.
  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// Pixels of the display for each that a program is used to: 2 on many small and fine ones.
  [[nodiscard]] double content_scale() const;
  [[nodiscard]] bool should_close() const;
  /// Shows the window's framebuffer, and waits for the display.
  void swap();
  /// Call it now and then in long work: it shows `progress` as title, responds to the display, and returns
  /// false once the user has pressed Escape or closes the window.
  [[nodiscard]] bool goes_on(const std::string& progress);
  /// Removes one tap of that key that no frame has taken in; false if there is none.
  [[nodiscard]] bool take_tap(Key key) { return queue_.take_tap(key); }
  void set_pointer(Pointer pointer);
  void set_title(const std::string& title);
  /// Puts a text into the clipboard of the display.
  void copy(const std::string& text);
  /// The text in it; empty if it has none.
  [[nodiscard]] std::string clipboard() const;
  /// Seconds since the program has a window.
  [[nodiscard]] static double seconds();
  /// Waits until the user does something, at most so many seconds. True if a frame has something to take in.
  [[nodiscard]] bool wait(double seconds) const;
  [[nodiscard]] bool has_input() const { return !queue_.is_empty(); }
  /// The next frame's share of the user's actions.
  [[nodiscard]] DebuggerInput take_input();

 private:
  /// GLFW is initialised once for the process, as long as a window lives.
  struct Library {
    Library();
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Close {
    void operator()(GLFWwindow* window) const;
  };
  static GLFWwindow* make_window(const std::string& title, int width, int height, bool grows);
  void listen();
  void paste(DebuggerInput& input) const;

  Library library_;
  std::unique_ptr<GLFWwindow, Close> window_;
  std::string title_;
  bool is_busy_ = false;  ///< another title is shown
  Pointer pointer_ = Pointer::arrow;
  std::array<GLFWcursor*, kPointerNames.size()> cursors_{};  ///< null: the arrow; the library's, not ours
  GlFunctions functions_;
  InputQueue queue_;  ///< the callbacks fill it
};

}  // namespace kerf

#pragma once

#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/debugger/gui/pace.h"

namespace kerf {

/// Shows a debugger in a window: draws when the user did something or the run plays on, else waits.
class WindowLoop {
 public:
  WindowLoop(GlfwWindow& window, Debugger& debugger);

  /// Waits for a reason to draw, but not longer than the end of the program may go unnoticed. False if
  /// nothing was drawn.
  bool turn();
  /// Shows the last frame in the window.
  void present();

 private:
  void take_in();

  GlfwWindow& window_;
  Debugger& debugger_;
  Pace pace_;
  double last_;  ///< time of the last frame
};

}  // namespace kerf

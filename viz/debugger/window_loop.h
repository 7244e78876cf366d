#pragma once

#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/debugger/gui/pace.h"

namespace kerf {

/// Shows a debugger in a window: draws when the user did something or the run plays on, else waits.
class WindowLoop {
 public:
  WindowLoop(GlfwWindow& window, Debugger& debugger);

  /// Waits for a reason to draw, but not for longer than it may take to see that the program is to end. False
  /// if nothing was drawn.
  bool turn();
  /// Puts the last frame into the window.
  void present();

 private:
  void take_in();

  GlfwWindow& window_;
  Debugger& debugger_;
  Pace pace_;
  double last_;  ///< time of the last frame
};

}  // namespace kerf

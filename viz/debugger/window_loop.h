#pragma once

#include <optional>

#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/debugger/gui/pace.h"

namespace kerf {

/// Shows a debugger in a window: draws when the user did something or the run plays on, else waits.
class WindowLoop {
 public:
  /// `scale` counts instead of the content scale of the window.
  WindowLoop(GlfwWindow& window, Debugger& debugger, std::optional<double> scale = std::nullopt);

  /// Waits for a reason to draw, but not longer than the end of the program may go unnoticed. False if
  /// nothing was drawn.
  bool turn();
  /// Shows the last frame in the window.
  void present();

 private:
  void take_in();

  GlfwWindow& window_;
  Debugger& debugger_;
  std::optional<double> scale_;
  Pace pace_;
  double last_;  ///< time of the last frame
};

}  // namespace kerf

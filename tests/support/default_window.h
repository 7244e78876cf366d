#pragma once

#include "viz/debugger/model/lanes.h"
#include "viz/debugger/window/arrangement.h"

namespace kerf::test {

/// Where everything is in a window with the default layout.
class DefaultWindow {
 public:
  DefaultWindow(int width, int height, std::size_t lanes = kLanesOfRun)
      : all_(arrange(layout_, {static_cast<float>(width), static_cast<float>(height), lanes - kLanesOfRun})) {
  }

  [[nodiscard]] PanelArea area(PanelId panel) const { return area_of(panel, layout_, all_); }
  [[nodiscard]] const Arrangement& all() const { return all_; }

 private:
  WindowLayout layout_;
  Arrangement all_;
};

}  // namespace kerf::test

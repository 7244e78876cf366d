#pragma once

#include <vector>

#include "viz/debugger/gui/panel_area.h"

struct ImDrawData;

namespace kerf {

/// What Dear ImGui has laid out beside the scene. While only the scene changes, as when its camera turns,
/// that is the same from frame to frame and need not be drawn again.
class LayoutBeside {
 public:
  /// Takes the layout of a frame. True if beside `scene` it is that of the frame before.
  bool take(const ImDrawData& data, const PanelArea& scene);
  /// The next frame is like none before.
  void forget() { scene_ = {}; }

 private:
  PanelArea scene_;
  std::vector<float> drawn_;  ///< limits and corners of all that is drawn, in its order
  std::vector<float> before_;
};

}  // namespace kerf

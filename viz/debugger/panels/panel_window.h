#pragma once

#include <imgui.h>

#include <string>

#include "viz/debugger/gui/gui.h"

namespace kerf {

/// A window that fills an area exactly, which is named for the tour and for scripts.
template <class Draw>
void in_window(Gui& gui, const std::string& name, const PanelArea& area, Draw draw, int flags = 0) {
  constexpr auto kFixedWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
  gui.name_area("panel " + name, area);
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, area.height});
  if (ImGui::Begin(name.c_str(), nullptr, kFixedWindow | flags)) draw();
  ImGui::End();
}

}  // namespace kerf

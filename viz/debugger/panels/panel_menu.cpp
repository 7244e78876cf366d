#include "viz/debugger/panels/panel_menu.h"

#include <imgui.h>

#include "viz/debugger/gui/widgets.h"

namespace kerf {
namespace {

constexpr std::array<const char*, 3> kToPlaces{"to the left column", "to the right column", "below the view"};

/// The cells beside which the panel can be a tab.
std::vector<CellIndex> other_cells(const WindowLayout& layout, PanelId panel) {
  std::vector<CellIndex> cells;
  for (const PanelPlace place : kPanelPlaces)
    for (std::size_t k = 0; k < layout.cells(place).size(); ++k)
      if (layout.find(panel) != CellIndex{place, k}) cells.push_back({place, k});
  return cells;
}

PanelId front_of(const WindowLayout& layout, const CellIndex& at) {
  const PanelCell& cell = layout.cells(at.place)[at.cell];
  return cell.tabs[cell.shown];
}

bool menu_item(PanelContext& context, const std::string& label, const std::string& name) {
  return widgets::row(context.gui, label, name, false);
}

void draw_zoom_items(PanelContext& context) {
  WindowSettings& window = context.memory.window;
  const int percent = static_cast<int>(100 * window.zoom + 0.5);
  ImGui::TextDisabled("text: %d %%", percent);
  if (menu_item(context, "larger      Ctrl +", "window larger")) window.zoom_by(true);
  if (menu_item(context, "smaller     Ctrl -", "window smaller")) window.zoom_by(false);
  if (menu_item(context, "as usual    Ctrl 0", "window usual")) window.zoom = 1;
}

void draw_theme_item(PanelContext& context) {
  ThemeName& theme = context.memory.window.theme;
  const bool is_dark = theme == ThemeName::dark;
  if (menu_item(context, is_dark ? "light theme" : "dark theme", "window theme"))
    theme = is_dark ? ThemeName::light : ThemeName::dark;
}

/// Open panels have a mark.
void draw_panel_items(PanelContext& context) {
  WindowLayout& layout = context.memory.window.layout;
  ImGui::TextDisabled("panels");
  for (std::size_t k = 0; k < kPanelCount; ++k) {
    const auto panel = static_cast<PanelId>(k);
    bool is_open = layout.is_open(panel);
    if (widgets::checkbox(context.gui, std::string(title_of(panel)).c_str(), is_open, "",
                          "window " + panel_name(panel))) {
      if (is_open) {
        layout.show(panel);
      } else {
        layout.close(panel);
      }
    }
    if (k % 2 == 0 && k + 1 < kPanelCount) ImGui::SameLine(130);
  }
}

}  // namespace

void draw_panel_menu(PanelContext& context, PanelId panel) {
  const ImVec2 corner = ImGui::GetWindowPos();
  ImGui::SetNextWindowPos({corner.x + ImGui::GetWindowWidth() - 8, corner.y + 22}, ImGuiCond_Appearing,
                          {1, 0});
  if (!ImGui::BeginPopup("panel menu")) return;
  WindowLayout& layout = context.memory.window.layout;
  ImGui::TextDisabled("%s", std::string(title_of(panel)).c_str());
  for (const PanelPlace place : kPanelPlaces) {
    const auto k = static_cast<std::size_t>(place);
    if (menu_item(context, kToPlaces[k], "menu " + std::string(kPlaceNames[k])))
      layout.move_to_end(panel, place);
  }
  const WindowLayout before = layout;
  for (const CellIndex& cell : other_cells(before, panel)) {
    const std::string title(title_of(front_of(before, cell)));
    if (menu_item(context, "as a tab beside " + title, "menu tab " + title))
      layout.move(panel, {cell, DropSide::tab});
  }
  if (menu_item(context, "close", "menu close")) layout.close(panel);
  ImGui::EndPopup();
}

void draw_window_menu(PanelContext& context) {
  if (widgets::button(context.gui, "window", "panels, size of texts, theme (F10)") ||
      std::exchange(context.memory.window_menu_wanted, false))
    ImGui::OpenPopup("window menu");
  ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 2}, ImGuiCond_Appearing);
  if (!ImGui::BeginPopup("window menu")) return;
  draw_zoom_items(context);
  ImGui::Separator();
  draw_theme_item(context);
  ImGui::Separator();
  draw_panel_items(context);
  ImGui::Separator();
  if (menu_item(context, "reset layout", "window reset")) context.memory.window.layout = WindowLayout();
  ImGui::EndPopup();
}

}  // namespace kerf

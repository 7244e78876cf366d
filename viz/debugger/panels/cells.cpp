#include "viz/debugger/panels/cells.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel_menu.h"
#include "viz/debugger/panels/panel_window.h"
#include "viz/debugger/window/drop.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kTitleHeight = 24;  // from the top of a cell
constexpr float kGripWidth = 15;
constexpr float kDragBegins = 8;  // pixels that the mouse moves before a panel follows it

/// How a panel is drawn. One with a heading of its own needs no tab above it.
struct PanelDrawing {
  void (*draw)(PanelContext&);
  bool has_heading = false;
  int flags = 0;
};
constexpr auto kNeverScrolls = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
constexpr std::array<PanelDrawing, kPanelCount> kPanelDrawings{{{draw_outline, true},
                                                                {draw_icicle, true, kNeverScrolls},
                                                                {draw_breakpoints, true},
                                                                {draw_events, true},
                                                                {draw_why},
                                                                {draw_ballot},
                                                                {draw_algorithm},
                                                                {draw_oracle},
                                                                {draw_what_if},
                                                                {draw_compare},
                                                                {draw_lint},
                                                                {draw_tables},
                                                                {draw_timeline, true, kNeverScrolls}}};
const PanelDrawing& drawing_of(PanelId panel) { return kPanelDrawings[static_cast<std::size_t>(panel)]; }

/// The mouse may drag the panel from here.
void hold_panel(PanelContext& context, PanelId panel) { context.memory.held_panel = panel; }

/// Three short lines at the right end of the title: press them for a menu, drag them to move the panel.
void draw_grip(PanelContext& context, PanelId panel) {
  const ImVec2 begin = ImGui::GetCursorPos();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 at{corner.x + ImGui::GetContentRegionAvail().x - kGripWidth + 2, corner.y + 1};
  ImGui::SetCursorScreenPos(at);
  const bool released = ImGui::InvisibleButton("grip", {kGripWidth, 16});
  context.gui.name_last_item("menu " + panel_name(panel));
  if (ImGui::IsItemActivated()) hold_panel(context, panel);
  if (released && !ImGui::IsMouseDragPastThreshold(0, kDragBegins)) ImGui::OpenPopup("panel menu");
  const ImU32 color = widgets::ink(ImGui::IsItemHovered() ? palette::kPartitioner : palette::kFaintInk);
  for (int k = 0; k < 3; ++k) {
    const float y = at.y + 4 + 4 * static_cast<float>(k);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + 2, y}, {at.x + kGripWidth - 3, y + 1.5F}, color);
  }
  widgets::hint("a menu of this panel; drag to move it");
  ImGui::SetCursorPos(begin);
}

/// What is neither button nor text field in the first row of a panel drags it; the right button opens its
/// menu.
void take_title(PanelContext& context, PanelId panel, const PanelArea& area) {
  const bool is_on_title = ImGui::GetIO().MousePos.y < area.y + kTitleHeight && ImGui::IsWindowHovered() &&
                           !ImGui::IsAnyItemHovered();
  if (!is_on_title) return;
  if (ImGui::IsMouseClicked(0)) hold_panel(context, panel);
  if (ImGui::IsMouseClicked(1)) ImGui::OpenPopup("panel menu");
}

void draw_panel_tab(PanelContext& context, const PanelCell& cell, std::size_t tab) {
  const PanelId panel = cell.tabs[tab];
  const std::string title(title_of(panel));
  const bool is_front = tab == cell.shown;
  const bool open = ImGui::BeginTabItem(title.c_str(), nullptr, is_front ? ImGuiTabItemFlags_SetSelected : 0);
  context.gui.name_last_item("tab " + title, title);
  if (ImGui::IsItemClicked()) {
    context.memory.window.layout.show(panel);
    hold_panel(context, panel);
  }
  const bool wants_menu = ImGui::IsItemClicked(1);
  if (wants_menu) context.memory.window.layout.show(panel);
  if (open) {
    ImGui::BeginChild(title.c_str(), {0, 0}, false, drawing_of(panel).flags);
    drawing_of(panel).draw(context);
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  if (wants_menu) context.memory.menu_wanted = true;
}

/// All tabs side by side, left of the grip.
void draw_panel_tabs(PanelContext& context, const PanelCell& cell) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, ImGui::GetStyle().FramePadding.y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {2, ImGui::GetStyle().ItemInnerSpacing.y});
  ImRect& room = ImGui::GetCurrentWindow()->WorkRect;
  const float right = room.Max.x;
  room.Max.x -= kGripWidth;
  const bool open = ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll);
  room.Max.x = right;
  if (open) {
    for (std::size_t tab = 0; tab < cell.tabs.size(); ++tab) draw_panel_tab(context, cell, tab);
    ImGui::EndTabBar();
  }
  ImGui::PopStyleVar(2);
  if (std::exchange(context.memory.menu_wanted, false)) ImGui::OpenPopup("panel menu");
}

void draw_cell(PanelContext& context, const PanelCell& cell, const PanelArea& area) {
  const PanelId front = cell.tabs[cell.shown];
  for (const PanelId panel : cell.tabs) context.gui.name_area("panel " + panel_name(panel), area);
  const bool is_bare = cell.tabs.size() == 1 && drawing_of(front).has_heading;
  in_window(
      context.gui, panel_name(cell.tabs.front()), area,
      [&] {
        draw_grip(context, front);
        if (is_bare) {
          drawing_of(front).draw(context);
        } else {
          draw_panel_tabs(context, cell);
        }
        take_title(context, front, area);
        draw_panel_menu(context, front);
      },
      is_bare ? drawing_of(front).flags : kNeverScrolls);
}

void draw_divider(PanelContext& context, const Arrangement& arrangement, const Divider& divider) {
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;
  const PanelArea& area = divider.area;
  context.gui.name_area(divider.name, area);
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, area.height});
  if (ImGui::Begin(divider.name.c_str(), nullptr, kFlags)) {
    ImGui::InvisibleButton("grip", {area.width, area.height});
    WindowLayout& layout = context.memory.window.layout;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
      reset_divider(layout, divider);
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 2)) {
      drag_divider(layout, arrangement, divider, mouse.x, mouse.y);
    }
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
      ImGui::SetMouseCursor(divider.is_upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
      const ImVec2 a{area.x + (divider.is_upright ? 2 : 0), area.y + (divider.is_upright ? 0 : 2)};
      const ImVec2 b{area.right() - (divider.is_upright ? 2 : 0),
                     area.bottom() - (divider.is_upright ? 0 : 2)};
      ImGui::GetWindowDrawList()->AddRectFilled(a, b, widgets::to_imgui(widgets::theme().divider));
    }
    widgets::hint("drag to resize; a double click brings it back");
  }
  ImGui::End();
}

}  // namespace

std::string panel_name(PanelId panel) {
  std::string name(title_of(panel));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

/// Panels may change the layout meanwhile, which holds from the next frame on.
void draw_cells(PanelContext& context, const Arrangement& arrangement) {
  const WindowLayout layout = context.memory.window.layout;
  for (const ArrangedCell& cell : arrangement.cells) {
    const auto& cells = layout.cells(cell.index.place);
    if (cell.index.cell < cells.size()) draw_cell(context, cells[cell.index.cell], cell.area);
  }
}

void draw_dividers(PanelContext& context, const Arrangement& arrangement) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  for (const Divider& divider : arrangement.dividers) draw_divider(context, arrangement, divider);
  ImGui::PopStyleVar(3);
}

void drag_panel(PanelContext& context, const Arrangement& arrangement) {
  PanelMemory& memory = context.memory;
  if (!memory.held_panel) return;
  const PanelId panel = *memory.held_panel;
  const bool is_dragged = ImGui::IsMouseDragPastThreshold(0, kDragBegins);
  const bool is_dropped = !ImGui::IsMouseDown(0);
  if (is_dropped) memory.held_panel.reset();
  if (!is_dragged) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto drop = drop_at(memory.window.layout, arrangement, panel, mouse.x, mouse.y);
  if (drop && is_dropped) return memory.window.layout.move(panel, drop->target);
  if (is_dropped) return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  if (drop) {
    const PanelArea& area = drop->area;
    const Color color = widgets::theme().divider;
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, widgets::to_imgui(color, 0.2));
    list.AddRect({area.x + 1, area.y + 1}, {area.right() - 1, area.bottom() - 1}, widgets::to_imgui(color), 0,
                 0, 2);
  }
  const std::string title(title_of(panel));
  const ImVec2 size = ImGui::CalcTextSize(title.c_str());
  const ImVec2 at{mouse.x + 12, mouse.y + 8};
  list.AddRectFilled({at.x - 5, at.y - 3}, {at.x + size.x + 5, at.y + size.y + 3},
                     widgets::to_imgui(widgets::theme().popup));
  list.AddText(at, widgets::ink(palette::kInk), title.c_str());
}

}  // namespace kerf

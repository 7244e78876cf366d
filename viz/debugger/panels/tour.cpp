#include <array>
#include <string>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/debugger/panels/panel_menu.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

/// A stop shows a part of the window at a moment worth a look.
struct TourStop {
  const char* title;
  const char* text;
  const char* panel;  ///< that is framed
  void (*set_up)(PanelContext& context);
};

void select_root(PanelContext& context) { context.model.select(context.model.run().tree().root()); }

void go_to_a_split(PanelContext& context) {
  context.model.go({});
  context.model.go_to_kind(EventKind::split, true);
}

void select_a_pair(PanelContext& context) {
  context.model.go_to_opening();
  const auto pairs = context.model.run().pairs();
  if (!pairs.empty()) context.model.select(pairs.front());
  context.memory.open_tab = "Why";
}

constexpr std::array<TourStop, 7> kStops{
    {{"The scene",
      "Objects are coloured as the leaves that hold them, blue planes divide the space, lines are pairs. "
      "Drag to turn it, the wheel goes nearer, and the mouse over something says what it is.",
      "panel view", [](PanelContext& context) { context.model.go_to_opening(); }},
     {"Time",
      "A lane for each figure of the run: drag to go there, the wheel magnifies. A click on a maximum at the "
      "right goes to it.",
      "panel timeline", [](PanelContext& context) { context.model.go_to_opening(); }},
     {"The tree",
      "A bar is a node, as wide as it has objects; below it lie its children. The root is selected: its "
      "plane is marked in the scene, and its life in the lowest lane.",
      "panel icicle", select_root},
     {"An operator",
      "The first split: a leaf had too many objects. `.` and `,` go from operator to operator, and the list "
      "has all events of the step.",
      "panel events", go_to_a_split},
     {"The choice",
      "Each row is a plane that could have been taken, with the figures by which it was judged. Press one, "
      "and the scene shows it.",
      "panel ballot",
      [](PanelContext& context) {
        go_to_a_split(context);
        context.memory.open_tab = "Ballot";
      }},
     {"Why",
      "Two objects are selected, a pair. Here stands why they are one, in which leaf they met, and since "
      "when.",
      "panel why", select_a_pair},
     {"Stop when",
      "Type a condition, for example `op==merge && depth>2` or `pairs>100`, and press F5: the run stops "
      "where it holds. Shift+F5 searches backwards. F1 has all keys.",
      "panel breakpoints", [](PanelContext& context) { context.model.select({}); }}}};

/// What the first stop says in 2D, where the areas of the leaves are coloured and a drag does not turn.
constexpr const char* kFlatScene =
    "Objects are blue or in the colour they were given, areas of leaves are coloured by how many they hold, "
    "blue lines divide the space, orange lines are pairs. Drag to move it, the wheel goes nearer, and the "
    "mouse over something says what it is.";

void frame_panel(PanelContext& context, const char* name) {
  const auto area = context.gui.find(name);
  if (!area) return;
  ImGui::GetForegroundDrawList()->AddRect({area->x + 1, area->y + 1},
                                          {area->x + area->width - 1, area->y + area->height - 1},
                                          widgets::to_imgui(palette::kOperator), 0, 0, 3);
}

/// The panel of a stop may have been closed.
void show_panel_of(PanelContext& context, const TourStop& stop) {
  for (std::size_t k = 0; k < kPanelCount; ++k) {
    const auto panel = static_cast<PanelId>(k);
    if (stop.panel == "panel " + panel_name(panel)) context.memory.window.layout.show(panel);
  }
}

/// Over the scene; where that is shown, beside it if there is room.
void place_card(const PanelArea& view, bool shows_scene) {
  constexpr float kWidth = 460;
  constexpr float kLeastWidth = 300;
  constexpr float kAround = 8;
  const float right = view.x + view.width;
  const float beside = ImGui::GetIO().DisplaySize.x - right - 2 * kAround;
  if (shows_scene && beside >= kLeastWidth) {
    ImGui::SetNextWindowPos({right + kAround, view.y + kAround});
    ImGui::SetNextWindowSize({std::min(kWidth, beside), 0});
    return;
  }
  ImGui::SetNextWindowPos({view.x + 0.5F * view.width, view.y + kAround}, ImGuiCond_Always, {0.5F, 0});
  ImGui::SetNextWindowSize({std::min(kWidth, view.width - 2 * kAround), 0});
}

void draw_buttons(PanelContext& context) {
  std::optional<std::size_t>& tour = context.memory.tour;
  const bool is_last = *tour + 1 == kStops.size();
  if (widgets::button(context.gui, is_last ? "end" : "next", "Enter", "next stop")) ++*tour;
  ImGui::SameLine();
  if (tour != 0 && widgets::button(context.gui, "back", "", "stop before")) --*tour;
  ImGui::SameLine();
  ImGui::TextDisabled("Enter goes on, Esc ends the tour");
}

}  // namespace

std::string tour_text(DebuggerModel& model, std::size_t stop) {
  const bool is_flat = model.run().info().dimension == 2;
  return stop == 0 && is_flat ? kFlatScene : kStops.at(stop).text;
}

void draw_tour(PanelContext& context) {
  PanelMemory& memory = context.memory;
  if (memory.tour && *memory.tour >= kStops.size()) memory.tour.reset();
  if (!memory.tour) {
    memory.toured.reset();
    return;
  }
  const TourStop& stop = kStops[*memory.tour];
  if (memory.toured != memory.tour) {
    memory.welcome = false;  // it would hide what some stops show
    show_panel_of(context, stop);
    stop.set_up(context);
  }
  memory.toured = memory.tour;
  frame_panel(context, stop.panel);
  const auto view = context.gui.find("view");
  if (!view) return;
  place_card(*view, *memory.tour == 0);
  constexpr auto kFlags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  const std::string title = std::to_string(*memory.tour + 1) + " of " + std::to_string(kStops.size()) + ": " +
                            stop.title + "###tour";
  if (ImGui::Begin(title.c_str(), nullptr, kFlags)) {
    widgets::wrapped_text(tour_text(context.model, *memory.tour));
    ImGui::Spacing();
    draw_buttons(context);
  }
  ImGui::End();
}

}  // namespace kerf

#include <algorithm>
#include <array>
#include <functional>

#include "viz/debugger/panels/panel_menu.h"

namespace kerf {
namespace {

constexpr float kWidenBy = 0.03F;   // of the window, by which a column gets wider
constexpr float kEnlargeBy = 0.1F;  // of two neighbours, by which a panel gets higher
constexpr double kCameraStep = 40;  // by which the camera moves

/// Collects the commands of which all words of a query are part.
class CommandList {
 public:
  CommandList(PanelContext& context, std::string_view query) : context_(context), query_(query) {}

  void add(const std::string& name, const std::string& note, std::function<void(PanelContext&)> go) {
    if (!has_all_words(name, query_)) return;
    hits_.push_back(
        {name, note, [context = context_, go = std::move(go)](DebuggerModel&) mutable { go(context); }});
  }
  [[nodiscard]] std::vector<SearchHit> take() { return std::move(hits_); }

 private:
  PanelContext& context_;
  std::string query_;
  std::vector<SearchHit> hits_;
};

void offer_settings(CommandList& commands) {
  commands.add("larger text", "Ctrl++", [](PanelContext& c) { c.memory.window.zoom_by(true); });
  commands.add("smaller text", "Ctrl+-", [](PanelContext& c) { c.memory.window.zoom_by(false); });
  commands.add("usual size of text", "Ctrl+0", [](PanelContext& c) { c.memory.window.zoom = 1; });
  commands.add("dark theme", "window", [](PanelContext& c) { c.memory.window.theme = ThemeName::dark; });
  commands.add("light theme", "window", [](PanelContext& c) { c.memory.window.theme = ThemeName::light; });
  commands.add("reset layout", "window", [](PanelContext& c) { c.memory.window.layout = WindowLayout(); });
  commands.add("menu of the window", "F10", [](PanelContext& c) { c.memory.window_menu_wanted = true; });
}

void offer_moves(CommandList& commands, PanelId panel, const WindowLayout& layout) {
  const std::string title(title_of(panel));
  commands.add("panel " + title + ": to the left column", "move",
               [panel](PanelContext& c) { c.memory.window.layout.move_to_end(panel, PanelPlace::left); });
  commands.add("panel " + title + ": to the right column", "move",
               [panel](PanelContext& c) { c.memory.window.layout.move_to_end(panel, PanelPlace::right); });
  commands.add("panel " + title + ": below the view", "move",
               [panel](PanelContext& c) { c.memory.window.layout.move_to_end(panel, PanelPlace::below); });
  for (const PanelPlace place : kPanelPlaces)
    for (std::size_t k = 0; k < layout.cells(place).size(); ++k) {
      const CellIndex cell{place, k};
      if (layout.find(panel) == cell) continue;
      const PanelCell& beside = layout.cells(place)[k];
      commands.add("panel " + title + ": tab beside " + std::string(title_of(beside.tabs[beside.shown])),
                   "move", [panel, cell](PanelContext& c) {
                     c.memory.window.layout.move(panel, {cell, DropSide::tab});
                   });
    }
}

/// Takes from the next cell, or from the one before if it is the last.
void enlarge(WindowLayout& layout, PanelId panel, float more) {
  const auto at = layout.find(panel);
  if (!at || layout.cells(at->place).size() < 2) return;
  const bool is_last = at->cell + 1 == layout.cells(at->place).size();
  const CellIndex first{at->place, is_last ? at->cell - 1 : at->cell};
  const auto& cells = layout.cells(at->place);
  const float a = cells[first.cell].share;
  const float b = cells[first.cell + 1].share;
  layout.divide(first, std::clamp(a / (a + b) + (is_last ? -more : more), 0.1F, 0.9F));
}

void offer_panels(CommandList& commands, const WindowLayout& layout) {
  for (std::size_t k = 0; k < kPanelCount; ++k) {
    const auto panel = static_cast<PanelId>(k);
    const std::string name = "panel " + std::string(title_of(panel));
    commands.add("show " + name, "panel", [panel](PanelContext& c) { c.memory.window.layout.show(panel); });
    if (!layout.is_open(panel)) continue;
    commands.add("close " + name, "panel", [panel](PanelContext& c) { c.memory.window.layout.close(panel); });
    commands.add(name + ": larger", "resize",
                 [panel](PanelContext& c) { enlarge(c.memory.window.layout, panel, kEnlargeBy); });
    commands.add(name + ": smaller", "resize",
                 [panel](PanelContext& c) { enlarge(c.memory.window.layout, panel, -kEnlargeBy); });
    offer_moves(commands, panel, layout);
  }
}

void zoom_in_middle(PanelContext& context, double clicks) {
  const auto view = context.gui.find("view");
  const double half = 0.5 * context.gui.scale();
  if (view) context.view.zoom(clicks, half * double{view->width}, half * double{view->height});
}

void offer_camera(CommandList& commands) {
  struct CameraWay {
    const char* name;
    double x;
    double y;
  };
  commands.add("nearer", "Ctrl+.", [](PanelContext& c) { zoom_in_middle(c, 1); });
  commands.add("farther", "Ctrl+,", [](PanelContext& c) { zoom_in_middle(c, -1); });
  for (const CameraWay& way : {CameraWay{"left", -kCameraStep, 0}, CameraWay{"right", kCameraStep, 0},
                               CameraWay{"up", 0, -kCameraStep}, CameraWay{"down", 0, kCameraStep}}) {
    commands.add("turn the view " + std::string(way.name), "Ctrl+arrows",
                 [way](PanelContext& c) { c.view.turn(way.x, way.y); });
    commands.add("move the view " + std::string(way.name), "Ctrl+Shift+arrows",
                 [way](PanelContext& c) { c.view.move(way.x, way.y); });
  }
}

/// The extent of a place in the window as it is now.
void widen_place(PanelContext& context, PanelPlace place, float more) {
  WindowLayout& layout = context.memory.window.layout;
  const float now = context.memory.extents[static_cast<std::size_t>(place)];
  if (!layout.cells(place).empty()) layout.set_extent(place, std::clamp(now + more, 0.05F, 0.8F));
}

void offer_extents(CommandList& commands) {
  struct NamedExtent {
    const char* name;
    const char* more;
    const char* less;
    PanelPlace place;
  };
  for (const NamedExtent& extent : {NamedExtent{"left column", "wider", "narrower", PanelPlace::left},
                                    NamedExtent{"right column", "wider", "narrower", PanelPlace::right},
                                    NamedExtent{"panels below", "higher", "lower", PanelPlace::below}})
    for (const bool more : {true, false})
      commands.add(std::string(extent.name) + ": " + (more ? extent.more : extent.less), "resize",
                   [place = extent.place, more](PanelContext& c) {
                     widen_place(c, place, more ? kWidenBy : -kWidenBy);
                   });
}

/// What is an area, but not for a click.
bool is_only_an_area(const std::string& name) {
  constexpr auto kAreas =
      std::to_array<std::string_view>({"view", "scrubber", "minimap", "icicle", "events"});
  return name.starts_with("panel ") || name.starts_with("divider ") ||
         std::ranges::find(kAreas, name) != kAreas.end();
}

/// Whatever can be clicked in the panels, by the name that scripts use.
void offer_presses(CommandList& commands, PanelContext& context, std::string_view query) {
  if (!query.starts_with("press")) return;
  for (const auto& [name, area] : context.gui.named())
    if (!is_only_an_area(name))
      commands.add("press " + name, "as a click does",
                   [name = name](PanelContext& c) { c.memory.press = name; });
}

}  // namespace

std::vector<SearchHit> window_hits(PanelContext& context, std::string_view query) {
  CommandList commands(context, query);
  offer_settings(commands);
  offer_camera(commands);
  offer_extents(commands);
  offer_panels(commands, context.memory.window.layout);
  offer_presses(commands, context, query);
  return commands.take();
}

}  // namespace kerf

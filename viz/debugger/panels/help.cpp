#include <array>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {
namespace {

struct KeyHelp {
  const char* key;
  const char* meaning;
};
constexpr std::array kKeys{
    KeyHelp{"Space", "play by steps, pause"},
    KeyHelp{", and .", "back and on, by operator (or what is chosen above)"},
    KeyHelp{"Shift+, and .", "a whole step back and on"},
    KeyHelp{"Home, End", "to the start, to the end"},
    KeyHelp{"F5, Shift+F5", "on, or back, to the next moment at which a breakpoint holds"},
    KeyHelp{"F9", "breakpoint at this moment"},
    KeyHelp{"B, Shift+B", "bookmark this moment, with a note; O: ask the oracle about it"},
    KeyHelp{"F", "look at what is selected; with nothing selected, at everything"},
    KeyHelp{"V, Shift+V", "in 3D: from the next, the previous side: iso, top, front, side"},
    KeyHelp{"H", "hide what is selected, or show it again"},
    KeyHelp{"I", "only what is below the selected node"},
    KeyHelp{"U, D, X", "tree: select the parent, a child (with Shift the right one), the sibling"},
    KeyHelp{"A", "icicle: the tree before the last operator that acted, or now"},
    KeyHelp{"T, Shift+T", "the table of nodes, of pairs"},
    KeyHelp{"Q",
            "ask what a ray through the mouse hits (2D: what holds the point); P: ray, box, sphere, nearest"},
    KeyHelp{"J", "lanes of the selected object (in a short run they come by themselves)"},
    KeyHelp{"P, Ctrl+P", "search: nodes, objects, pairs, events, steps, conditions, queries, commands"},
    KeyHelp{"", "`press` and a name: whatever can be clicked; `panel`: move, close, show"},
    KeyHelp{"F10", "the window: panels, size of texts, light or dark"},
    KeyHelp{"Ctrl+ + - 0", "larger and smaller texts, as usual"},
    KeyHelp{"Ctrl+arrows", "turn the view; with Shift move it; Ctrl+. and , nearer and farther"},
    KeyHelp{"G", "what is seen, in words, and what colours mean"},
    KeyHelp{"Esc", "select nothing, no range; close this"},
    KeyHelp{"+ and -", "lanes: magnify around this moment, show more; R: the whole run"},
    KeyHelp{"Left, Right", "lanes: pan; Up, Down: choose a lane"},
    KeyHelp{"S, E", "range: starts, ends here (or Shift and a left drag); L: loop it; R: show it"},
    KeyHelp{"M, Shift+M", "to the maximum, to the minimum of the chosen lane; C: clip outliers or not"},
    KeyHelp{"1 to 9, 0", "to the next of a kind, see the list above the lanes; with Shift back"},
    KeyHelp{"N, Shift+N", "to the next, to the previous of the chosen kind; K: choose another"},
    KeyHelp{"W, Shift+W", "to the next, to the previous error: a wrong pair of an import; else a wrong step"},
    KeyHelp{"Ctrl+Z, Ctrl+Y",
            "undo, redo a change of what is seen: layers, colours, camera, lanes, selection"},
    KeyHelp{"Ctrl+C", "copy the panel under the mouse, or the last one used; with Shift as CSV"},
    KeyHelp{"Ctrl+O", "open another recording (or drop it on the window)"},
    KeyHelp{"F12", "save a picture, named by the moment"},
    KeyHelp{"F1, ?", "this help"},
    KeyHelp{"", ""},
    KeyHelp{"Left drag", "turn the view (2D: move it)"},
    KeyHelp{"Right drag", "move the view"},
    KeyHelp{"Wheel", "nearer and farther"},
    KeyHelp{"Click", "select an object; with Shift a second one: a pair; beside objects a node"},
    KeyHelp{"Ctrl+click", "select a node: the partitioner with a line there, or the leaf"},
    KeyHelp{"Panels", "drag a title or tab to another panel; drag lines between them, double click: back"},
    KeyHelp{"Lanes, below", "left drag: scrub; right or middle drag: pan; wheel: magnify at the mouse"},
    KeyHelp{"", "Shift+wheel or sideways: pan; the map below them: drag the window"},
};

}  // namespace

void draw_help(PanelContext& context) {
  if (!context.memory.help) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  constexpr auto kFlags =
      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize;
  ImGui::SetNextWindowFocus();
  if (ImGui::Begin("Keys and mouse", &context.memory.help, kFlags)) {
    if (widgets::button(context.gui, "close")) context.memory.help = false;
    ImGui::SameLine();
    if (widgets::button(context.gui, "tour", "seven stops, each with a look at this run")) {
      context.memory.help = false;
      context.memory.tour = 0;
    }
    ImGui::Spacing();
    for (const KeyHelp& help : kKeys) {
      ImGui::TextUnformatted(help.key);
      ImGui::SameLine(150);
      ImGui::TextUnformatted(help.meaning);
    }
  }
  ImGui::End();
}

}  // namespace kerf

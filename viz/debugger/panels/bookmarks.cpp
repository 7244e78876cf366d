#include <optional>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {
namespace {

/// True if it is to be removed.
bool draw_bookmark(PanelContext& context, std::size_t k, const Position& moment, std::string& note) {
  const std::string number = std::to_string(k);
  ImGui::PushID(2000 + static_cast<int>(k));
  ImGui::AlignTextToFramePadding();
  const bool removed = ImGui::SmallButton("x");
  context.gui.name_last_item("remove bookmark " + number);
  ImGui::SameLine();
  const bool pressed = ImGui::SmallButton(to_string(moment, context.model.run().names()).c_str());
  context.gui.name_last_item("bookmark " + number);
  widgets::hint("go there");
  ImGui::SameLine();
  widgets::text_field(context.gui, ("note " + number).c_str(), note, "note", -1);
  if (context.memory.session.note_of == moment) {  // the field that was just made takes the keys
    ImGui::SetKeyboardFocusHere(-1);
    context.memory.session.note_of.reset();
  }
  if (!note.empty()) widgets::hint(note.c_str());  // it may be longer than the field
  ImGui::PopID();
  if (pressed) context.model.go(moment);
  return removed;
}

}  // namespace

void draw_bookmarks(PanelContext& context) {
  auto& bookmarks = context.model.bookmarks;
  ImGui::Spacing();
  ImGui::TextUnformatted("Bookmarks");
  if (bookmarks.empty()) {
    ImGui::SameLine();
    ImGui::TextDisabled("B; Shift+B: note");
  }
  std::optional<Position> removed;
  std::size_t k = 0;
  for (auto& [moment, note] : bookmarks)
    if (draw_bookmark(context, k++, moment, note)) removed = moment;
  if (removed) bookmarks.erase(*removed);
}

}  // namespace kerf

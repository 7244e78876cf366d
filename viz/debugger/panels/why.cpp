#include <regex>
#include <set>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {
namespace {

/// Links to the nodes and events in the text.
void draw_links(PanelContext& context, const std::string& text) {
  constexpr std::size_t kMost = 24;
  static const std::regex kName(R"(\b([ne])(\d+)\b)");
  std::set<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), kName), end; it != end && names.size() < kMost; ++it)
    names.insert((*it)[0]);
  if (names.empty()) return;
  ImGui::Separator();
  ImGui::TextDisabled("go to");
  for (const std::string& name : names) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < 60) ImGui::NewLine();
    const bool pressed = ImGui::SmallButton(name.c_str());
    context.gui.name_last_item("link " + name, name);
    if (!pressed) continue;
    const auto number = std::stoull(name.substr(1));
    if (name.front() == 'e') {
      context.model.go_to_event(number);
    } else {
      context.model.select(NodeId{static_cast<std::uint32_t>(number)});
    }
  }
}

}  // namespace

const std::string& explanation_of(PanelContext& context) {
  PanelMemory& memory = context.memory;
  DebuggerModel& model = context.model;
  const Position& now = model.run().position();
  const std::string& query = model.view.query;
  if (memory.explained == model.selection() && memory.explained_at == now && memory.explained_query == query)
    return memory.explanation;
  memory.explained = model.selection();
  memory.explained_at = now;
  memory.explained_query = query;
  try {
    const bool of_event = is_nothing(model.selection());
    memory.explanation = of_event ? std::string() : model.run().explain(model.selection());
    if (of_event && !now.is_end()) memory.explanation = model.run().explain_event(now.event);
    if (of_event && !query.empty()) memory.explanation = model.run().explain_query(query);
  } catch (const std::exception& error) {
    memory.explanation = error.what();
  }
  return memory.explanation;
}

void draw_why(PanelContext& context) {
  DebuggerModel& model = context.model;
  const bool nothing = is_nothing(model.selection());
  if (!nothing) {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s", model.run().title(model.selection()).c_str());
    ImGui::SameLine();
    if (widgets::button(context.gui, "deselect", "explain the event instead (Esc)")) model.select({});
  }
  const std::string text = explanation_of(context);
  if (text.empty()) {
    ImGui::TextWrapped("%s",
                       "Select a node in the tree or an object in the view (click; with Shift a second one "
                       "makes a pair), or go to an event: here stands why it is so.");
    return;
  }
  widgets::wrapped_text(text);
  draw_links(context, text);
}

}  // namespace kerf

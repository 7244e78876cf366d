#include <algorithm>

#include "core/base/overloaded.h"
#include "core/trace/event_facts.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

bool is_listed(const Event& event, bool operators_only) { return !operators_only || !object_of(event); }

Color color_of_event(const Event& event) {
  return std::visit(Overloaded{
                        [](const PhaseBegan&) { return palette::kPartitioner; },
                        [](const ObjectPlaced&) { return palette::kInk; },
                        [](const OperatorScheduled&) { return palette::kInk; },
                        [](const OperatorActed&) { return palette::kOperator; },
                        [](const OperatorRefused&) { return palette::kCandidate; },
                        [](const EventsDeferred&) { return palette::kInk; },
                        [](const AllPlaced&) { return palette::kInk; },
                    },
                    event.body);
}

void draw_event_row(PanelContext& context, const Event& event) {
  const std::string id = "e" + std::to_string(event.id);
  const bool is_now = context.model.run().position().event == event.id;
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(color_of_event(event)));
  std::string text = id;
  text.resize(std::max<std::size_t>(text.size() + 1, 8), ' ');
  const bool pressed =
      widgets::row(context.gui, text + deed_text(event, context.model.run().names()), id, is_now);
  ImGui::PopStyleColor();
  if (pressed) context.model.go({event.step, event.id});
}

/// Scrolls to the event that has just happened.
void follow(PanelContext& context, const std::vector<const Event*>& events, float row_height) {
  const Position& now = context.model.run().position();
  if (context.memory.listed == now) return;
  context.memory.listed = now;
  const auto reached =
      std::ranges::find_if(events, [&](const Event* event) { return event->id >= now.event; });
  const auto row = static_cast<float>(reached - events.begin());
  ImGui::SetScrollY(std::max(0.0F, row * row_height - 0.4F * ImGui::GetWindowHeight()));
}

/// Says which events these are, in as many words as fit left of `end`.
void draw_heading(PanelContext& context, std::size_t listed, float end) {
  const Run& run = context.model.run();
  const std::string step = run.names().step(run.position().step);
  std::string title = "Events of step " + step;
  std::string count = std::to_string(listed) + " of " + std::to_string(run.events_of_step().size());
  const float room = end - ImGui::GetCursorPosX() - 2 * ImGui::GetStyle().ItemSpacing.x;
  const auto is_too_long = [&] { return ImGui::CalcTextSize((title + count).c_str()).x > room; };
  if (is_too_long()) title = "Step " + step;
  if (is_too_long()) count = std::to_string(listed);
  ImGui::TextUnformatted(title.c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("%s", count.c_str());
  context.gui.note_last_item("events shown");
}

}  // namespace

std::string deed_text(const Event& event, const GivenNames& names) {
  const std::string text = describe(event, names);
  const std::string front = "e" + std::to_string(event.id) + " step " + names.step(event.step) + " ";
  return text.substr(std::min(front.size(), text.size()));
}

std::vector<const Event*> listed_events(const PanelContext& context) {
  std::vector<const Event*> listed;
  for (const Event& event : context.model.run().events_of_step())
    if (is_listed(event, context.memory.operators_only)) listed.push_back(&event);
  return listed;
}

void draw_events(PanelContext& context) {
  const auto events = listed_events(context);
  const float box = ImGui::GetWindowWidth() - 172;
  draw_heading(context, events.size(), box);
  ImGui::SameLine(box);
  widgets::checkbox(context.gui, "without objects", context.memory.operators_only,
                    "leave out the objects that were placed in other leaves");
  ImGui::BeginChild("list of events", {0, 0}, true);
  context.gui.name_area("events", {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y, ImGui::GetWindowWidth(),
                                   ImGui::GetWindowHeight()});
  follow(context, events, ImGui::GetTextLineHeightWithSpacing());
  if (events.empty()) ImGui::TextDisabled("nothing happened: step on with '.', or press End");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(events.size()), ImGui::GetTextLineHeightWithSpacing());
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
      draw_event_row(context, *events[static_cast<std::size_t>(k)]);
  ImGui::EndChild();
}

}  // namespace kerf

#include <cmath>
#include <stdexcept>

#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr const char* kExamples =
    "Enter adds it, F5 runs to it; for example\n  op==merge && depth>8\n  pair(12,77) enters\n  plane(n17) "
    "moves\n  redundancy>5%\n"
    "  deferred>16\n  step_time>2*median\n  missed>0\n`kerf step --help` has all words";

template <class Add>
void try_adding(PanelContext& context, std::string& text, Add add) {
  try {
    add(text);
    text.clear();
    context.memory.problem.clear();
  } catch (const std::invalid_argument& error) {
    context.memory.problem = error.what();
  }
}

void draw_breakpoint(PanelContext& context, std::size_t k) {
  Breakpoint& breakpoint = context.model.breakpoints[k];
  const std::string number = std::to_string(k);
  ImGui::PushID(static_cast<int>(k));
  const bool removed = ImGui::SmallButton("x");
  context.gui.name_last_item("remove breakpoint " + number);
  ImGui::SameLine();
  widgets::checkbox(context.gui, "##on", breakpoint.enabled, "", "breakpoint " + number);
  ImGui::SameLine();
  ImGui::TextWrapped("%s", breakpoint.condition.text().c_str());
  if (breakpoint.hits > 0) {
    ImGui::SameLine();
    ImGui::TextDisabled("%ux", breakpoint.hits);
  }
  ImGui::PopID();
  if (removed) context.model.remove_breakpoint(k);
}

/// As short as possible: value and hits stand beside it.
const char* stop_word(const std::optional<Change>& stop) {
  if (!stop) return " - ";
  return stop == Change::any ? "change" : "true";
}

std::optional<Change> next_choice(const std::optional<Change>& stop) {
  if (!stop) return Change::any;
  return stop == Change::any ? std::optional(Change::becomes_true) : std::nullopt;
}

void draw_watch(PanelContext& context, std::size_t k) {
  const WatchedValue& watch = context.model.watches()[k];
  ImGui::PushID(1000 + static_cast<int>(k));
  const bool removed = ImGui::SmallButton("x");
  context.gui.name_last_item("remove watch " + std::to_string(k));
  ImGui::SameLine();
  const bool pressed = ImGui::SmallButton(stop_word(watch.stop));
  context.gui.name_last_item("watch stop " + std::to_string(k));
  widgets::hint("press: stop when it changes, when it becomes true, or not at all (-)");
  if (pressed) context.model.stop_at_watch(k, next_choice(watch.stop));
  ImGui::SameLine();
  const std::string text = watch.value.exists() ? to_text(watch.value) : "-";
  const std::string hits = watch.hits > 0 ? " " + std::to_string(watch.hits) + "x" : "";
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize((" = " + text + hits).c_str()).x;
  widgets::text_within(context.gui, watch.expression.text(), palette::kInk, room);
  ImGui::SameLine();
  ImGui::TextUnformatted("=");
  ImGui::SameLine();
  ImGui::TextColored(widgets::to_vector(palette::kPartitioner), "%s", text.c_str());
  if (watch.hits > 0) {
    ImGui::SameLine();
    ImGui::TextDisabled("%ux", watch.hits);
  }
  ImGui::PopID();
  if (removed) context.model.remove_watch(k);
}

}  // namespace

void draw_breakpoints(PanelContext& context) {
  DebuggerModel& model = context.model;
  PanelMemory& memory = context.memory;
  ImGui::TextUnformatted("Stop when");
  if (widgets::text_field(context.gui, "condition", memory.condition, "op==merge && depth>8", -1))
    try_adding(context, memory.condition, [&](const std::string& text) { model.add_breakpoint(text); });
  widgets::hint(kExamples);
  for (std::size_t k = 0; k < model.breakpoints.size(); ++k) draw_breakpoint(context, k);
  ImGui::Spacing();
  ImGui::TextUnformatted("Watch");
  if (widgets::text_field(context.gui, "watch", memory.watch, "redundancy", -1))
    try_adding(context, memory.watch, [&](const std::string& text) { model.add_watch(text); });
  widgets::hint("any expression: its value at each moment; the run can stop when it changes");
  for (std::size_t k = 0; k < model.watches().size(); ++k) draw_watch(context, k);
  draw_bookmarks(context);
  if (memory.problem.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(palette::kCandidate));
  ImGui::TextWrapped("%s", memory.problem.c_str());
  ImGui::PopStyleColor();
}

}  // namespace kerf

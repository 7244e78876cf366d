#include <algorithm>
#include <array>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/debugger/panels/panel_menu.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kRoomy = 1000;  // a window of this width has room for a longer field

struct GranularityName {
  Granularity granularity;
  const char* name;
};
constexpr std::array kGranularities{
    GranularityName{Granularity::step, "step"}, GranularityName{Granularity::phase, "phase"},
    GranularityName{Granularity::op, "operator"}, GranularityName{Granularity::event, "event"},
    GranularityName{Granularity::candidate, "candidate"}};

void draw_steps(PanelContext& context) {
  DebuggerModel& model = context.model;
  const auto go = [&](const char* label, const char* name, const char* hint, Granularity by, bool forwards) {
    if (widgets::button(context.gui, label, hint, name)) model.step(by, forwards);
    ImGui::SameLine();
  };
  go("|<", "start", "to the start (Home)", Granularity::run, false);
  go("<<", "step back", "one step back (Shift+,)", Granularity::step, false);
  go("<", "back", "back by what is chosen on the right (,)", model.granularity, false);
  const char* const label = model.playing ? "pause" : "play ";
  if (widgets::button(context.gui, label, "play and pause, step by step (Space)", "play"))
    model.playing = !model.playing;
  ImGui::SameLine();
  go(">", "forward", "on by what is chosen on the right (.)", model.granularity, true);
  go(">>", "step forward", "one step on (Shift+.)", Granularity::step, true);
  go(">|", "end", "to the end (End)", Granularity::run, true);
}

void draw_granularity(PanelContext& context) {
  ImGui::TextDisabled("by");
  ImGui::SameLine();
  const char* now = "";
  for (const GranularityName& item : kGranularities)
    if (item.granularity == context.model.granularity) now = item.name;
  ImGui::SetNextItemWidth(100);
  const bool open = ImGui::BeginCombo("##by", now);
  context.gui.name_last_item("granularity");
  if (open) {
    for (const GranularityName& item : kGranularities) {
      const bool chosen = item.granularity == context.model.granularity;
      if (widgets::row(context.gui, item.name, std::string("by ") + item.name, chosen))
        context.model.granularity = item.granularity;
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  auto speed = static_cast<float>(context.model.speed);
  if (widgets::slider(context.gui, "speed", speed, {1, 200, true}, "%.0f steps/s", 110))
    context.model.speed = double{speed};
  widgets::hint("how fast it plays; a scene has 25 steps in a second");
}

void draw_runs(PanelContext& context) {
  DebuggerModel& model = context.model;
  if (widgets::button(context.gui, "< run", "back to the last moment at which a breakpoint holds (Shift+F5)",
                      "reverse continue"))
    model.run_to_breakpoint(false);
  ImGui::SameLine();
  if (widgets::button(context.gui, "run >", "on to the next moment at which a breakpoint holds (F5)",
                      "continue"))
    model.run_to_breakpoint(true);
  ImGui::SameLine();
  if (widgets::button(context.gui, "mark", "bookmark this moment (B)", "bookmark")) model.toggle_bookmark();
  ImGui::SameLine();
  const Run& run = model.run();
  const std::string step_there_is = run.names().step(std::min(run.steps(), 17U));
  const std::string hint = "go to " + step_there_is + " or e1234";
  const bool is_roomy = ImGui::GetIO().DisplaySize.x >= kRoomy;
  const bool entered = widgets::text_field(context.gui, "go to", context.memory.go_to,
                                           is_roomy ? hint.c_str() : "go to", is_roomy ? 140 : 84);
  if (!entered || context.memory.go_to.empty()) return;
  const std::string text = context.memory.go_to;
  context.memory.go_to.clear();
  const auto event = text.front() == 'e' ? parse_given_id(std::string_view(text).substr(1)) : std::nullopt;
  if (event && !event->negative) return model.go_to_event(event->magnitude);
  if (const auto step = run.names().find_step(text)) return model.go(Position::end_of(*step));
  model.message = "'" + text + "' is neither a step such as " + step_there_is + " nor an event such as e1234";
  model.message_is_error = true;
}

/// As much of the message as fits; a hint has the rest.
void draw_message(PanelContext& context, const std::string& message) {
  ImGui::SameLine();
  const Color color = context.model.message_is_error ? palette::kCandidate : palette::kFaintInk;
  widgets::text_within(context.gui, message, color, ImGui::GetContentRegionAvail().x);
  context.gui.note_last_item("message");
}

/// The present moment in words: the same id as in lists, on the command line and in file names.
void draw_moment_line(PanelContext& context) {
  const DebuggerModel& model = context.model;
  const Run& run = model.run();
  ImGui::TextColored(widgets::to_vector(palette::kPartitioner), "%s", moment_words(run).c_str());
  ImGui::SameLine();
  const std::string message = model.message.empty() ? "" : "  " + model.message;
  const std::string steps = "of " + counted(run.steps(), "step");
  const std::string with_state = steps + "   state " + to_hex(run.state_hash());
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x;
  const bool has_room = ImGui::CalcTextSize((with_state + message).c_str()).x <= room;
  ImGui::TextDisabled("%s", has_room ? with_state.c_str() : steps.c_str());
  if (!message.empty()) draw_message(context, message);
}

}  // namespace

std::string moment_words(const Run& run) {
  if (run.position().step == 0) return "before the first step";
  const auto event = run.event();
  return event ? describe(*event, run.names()) : "end of step " + run.names().step(run.position().step);
}

void draw_transport(PanelContext& context) {
  draw_steps(context);
  draw_granularity(context);
  ImGui::SameLine(0, 18);
  draw_runs(context);
  ImGui::SameLine(0, 18);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttons =
      ImGui::CalcTextSize("picturesearchhelpwindow").x + 8 * style.FramePadding.x + 3 * style.ItemSpacing.x;
  if (ImGui::GetContentRegionAvail().x < buttons) ImGui::NewLine();
  if (widgets::button(context.gui, "picture", "save what is seen (F12)")) context.memory.screenshot = true;
  ImGui::SameLine();
  if (widgets::button(context.gui, "search",
                      "nodes, objects, pairs, events, steps, conditions, commands (P or Ctrl+P)"))
    open_search(context.memory.search);
  ImGui::SameLine();
  if (widgets::button(context.gui, "help", "keys and mouse (F1 or ?)")) context.memory.help = true;
  ImGui::SameLine();
  draw_window_menu(context);
  draw_moment_line(context);
}

}  // namespace kerf

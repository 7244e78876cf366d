#include "core/base/counted.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

void draw_list(PanelContext& context, const char* name, const char* meaning, const std::vector<Pair>& pairs) {
  constexpr std::size_t kMost = 500;
  const bool good = pairs.empty();
  ImGui::TextColored(widgets::to_vector(good ? palette::kSeries[2] : palette::kCandidate), "%s: %zu", name,
                     pairs.size());
  ImGui::SameLine();
  ImGui::TextDisabled("%s", meaning);
  for (std::size_t k = 0; k < std::min(kMost, pairs.size()); ++k) {
    const Selection pair = pairs[k];
    const std::string text = to_string(pair, context.model.run().names());
    ImGui::Indent();
    if (widgets::row(context.gui, text, std::string(name) + " " + std::to_string(k),
                     context.model.selection() == pair)) {
      context.model.select(pair);
      context.view.focus(pair);
    }
    ImGui::Unindent();
  }
  if (pairs.size() > kMost) ImGui::TextDisabled("and %zu more", pairs.size() - kMost);
}

void draw_error_buttons(PanelContext& context) {
  DebuggerModel& model = context.model;
  for (const bool forwards : {false, true}) {
    if (forwards) ImGui::SameLine();
    if (widgets::button(context.gui, forwards ? "next error" : "previous error",
                        forwards
                            ? "the next wrong pair: goes to its step and selects it (W)"
                            : "the wrong pair before this one: goes to its step and selects it (Shift+W)") &&
        model.go_to_error(forwards))
      context.view.focus(model.selection());
  }
  if (!model.run().has_theirs()) return;
  ImGui::SameLine();
  if (!widgets::button(context.gui, "all errors", "a table of the wrong pairs of all steps")) return;
  context.memory.table_of = TableOf::errors;
  context.memory.open_tab = "Tables";
}

/// The errors of the whole run, as far as they are known, and ways to them.
void draw_errors_of_run(PanelContext& context) {
  DebuggerModel& model = context.model;
  const bool theirs = model.run().has_theirs();
  const std::size_t before_first = model.alarms().contains(0) ? 1 : 0;
  const std::string judged = counted(model.alarms().size() - before_first, "step");
  widgets::wrapped_text(
      theirs ? counted(model.run().wrong_pairs().size(), "error") + " of the other engine, in " +
                   std::to_string(model.wrong_steps().size()) + " of " + judged
             : judged + " asked so far, " + std::to_string(model.wrong_steps().size()) + " of them wrong");
  draw_error_buttons(context);
  if (const auto at = model.wrong_pair()) {
    ImGui::SameLine();
    ImGui::TextDisabled("error %zu", *at + 1);
  }
  ImGui::Separator();
}

}  // namespace

void draw_oracle(PanelContext& context) {
  DebuggerModel& model = context.model;
  const std::uint32_t step = model.run().position().step;
  const std::string name = model.run().names().step(step);
  const bool imported = model.run().has_theirs();
  draw_errors_of_run(context);
  if (!model.alarms().contains(step)) {
    ImGui::TextWrapped("Brute force has not been asked about step %s: with so many objects it takes a while.",
                       name.c_str());
    if (widgets::button(context.gui, "ask the oracle", "compare with every pair of boxes (O)"))
      (void)model.ask_oracle();
    return;
  }
  const PairJudgement& judgement = model.run().judgement();
  const std::uint64_t reported = model.run().judged_pairs();
  ImGui::TextWrapped("%s of step %s beside all pairs of boxes that overlap, by brute force:",
                     imported ? "The pairs that the other engine reported" : "The tree's pairs",
                     name.c_str());
  ImGui::Text("reported: %llu", static_cast<unsigned long long>(reported));
  const std::uint64_t wrong = judgement.extra.size() + judgement.twice.size();
  if (judgement.ignored.empty() && judgement.undecided.empty())
    ImGui::Text("true: %llu", static_cast<unsigned long long>(reported - wrong + judgement.missed.size()));
  draw_list(context, "missed", "they overlap, and were not reported", judgement.missed);
  draw_list(context, "false", "reported, but no overlap", judgement.extra);
  draw_list(context, "twice", "reported again", judgement.twice);
  if (imported) draw_list(context, "ignored", "no fault, by what was declared", judgement.ignored);
  if (!judgement.undecided.empty())
    draw_list(context, "undecided", "they touch only in the digits that were written", judgement.undecided);
  if (imported) return;
  ImGui::Separator();
  ImGui::TextWrapped("A breakpoint missed>0 || extra>0 || twice>0 asks about all steps.");
}

}  // namespace kerf

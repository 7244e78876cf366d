#include <algorithm>
#include <cstdio>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "core/tree/partitioner.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kStripHeight = 110;

Color color_of(const BallotEntry& entry) {
  if (entry.taken || entry.result == Ballot::chosen) return palette::kSeries[2];
  const bool is_good = entry.result == Ballot::beaten || entry.result == Ballot::overruled;
  return is_good ? palette::kInk : palette::kCandidate;
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

std::string two_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", x);
  return text;
}

/// Below the row that it is about, which it would hide, and within the window.
void draw_hint_below_row(const CandidateRow& candidate) {
  const std::string text =
      candidate.plane + "\n" + result_text(candidate.entry) + "\n" +
      (candidate.entry.exact ? "judged on all its objects" : "judged on a sample of its objects");
  const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().WindowPadding.x;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos(
      {std::min(io.MousePos.x + 16, io.DisplaySize.x - width), ImGui::GetItemRectMax().y + 2});
  ImGui::SetTooltip("%s", text.c_str());
}

/// True if the mouse is over the row.
bool draw_candidate_row(PanelContext& context, std::size_t k, const CandidateRow& candidate) {
  const Quality& q = candidate.entry.quality;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(color_of(candidate.entry)));
  const bool selected = context.model.hovered_candidate == k;
  const std::string name = "candidate " + std::to_string(k);
  const bool pressed = ImGui::Selectable((std::to_string(k) + "##" + name).c_str(), selected,
                                         ImGuiSelectableFlags_SpanAllColumns);
  context.gui.name_last_item(name);
  const bool hovered = ImGui::IsItemHovered();
  if (pressed) context.memory.kept_candidate = k;
  if (hovered) draw_hint_below_row(candidate);
  cell(candidate.plane);
  cell(std::to_string(q.left) + "|" + std::to_string(q.right));
  cell(two_digits(double{balance(q)}));
  cell(std::to_string(redundancy(q)));
  cell(two_digits(candidate.score));
  cell(result_word(candidate.entry));
  ImGui::PopStyleColor();
  return hovered;
}

std::optional<std::size_t> draw_table(PanelContext& context, const std::vector<CandidateRow>& ballot) {
  std::optional<std::size_t> hovered;
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerV |
                          ImGuiTableFlags_SizingFixedFit;
  const float height = std::max(80.0F, ImGui::GetContentRegionAvail().y - kStripHeight - 26);
  if (!ImGui::BeginTable("candidates", 7, kFlags, {0, height})) return hovered;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("#");
  ImGui::TableSetupColumn("plane", ImGuiTableColumnFlags_WidthStretch);
  for (const char* const name : {"l|r", "bal", "cut", "score", "result"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  for (std::size_t k = 0; k < ballot.size(); ++k)
    if (draw_candidate_row(context, k, ballot[k])) hovered = k;
  ImGui::EndTable();
  return hovered;
}

/// The objects on the candidate's direction, a line each, by their lower ends, and the plane between them.
void draw_strip(const ProjectionStrip& strip) {
  if (strip.intervals.empty()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetContentRegionAvail().y - 2;
  double low = double{strip.intervals.front().lo};
  double high = low;
  for (const Interval& interval : strip.intervals) high = std::max(high, double{interval.hi});
  low = std::min(low, strip.offset);
  high = std::max(high, strip.offset);
  const auto x_of = [&](double at) {
    return origin.x + 3 + static_cast<float>((at - low) / std::max(1e-9, high - low)) * (width - 6);
  };
  list.AddRectFilled(origin, {origin.x + width, origin.y + height},
                     widgets::to_imgui(widgets::theme().paper));
  constexpr std::size_t kMostLines = 300;  // more than the strip has rows of pixels
  const std::size_t every = 1 + strip.intervals.size() / kMostLines;
  const float row = (height - 4) / static_cast<float>(strip.intervals.size());
  for (std::size_t k = 0; k < strip.intervals.size(); k += every) {
    const Interval& interval = strip.intervals[k];
    const Sides sides = classify(interval, static_cast<Scalar>(strip.offset));
    const Color color = sides.straddle() ? palette::kCandidate
                        : sides.left     ? palette::kPartitioner
                                         : palette::kSeries[2];
    const float y = origin.y + 2 + row * static_cast<float>(k);
    list.AddRectFilled(
        {x_of(double{interval.lo}), y},
        {std::max(x_of(double{interval.hi}), x_of(double{interval.lo}) + 1), y + std::max(1.0F, row - 0.6F)},
        widgets::to_imgui(color));
  }
  list.AddLine({x_of(strip.offset), origin.y}, {x_of(strip.offset), origin.y + height},
               widgets::to_imgui(palette::kInk), 2);
  ImGui::Dummy({width, height});
}

}  // namespace

const char* result_word(const BallotEntry& entry) {
  if (entry.taken) return "taken";
  switch (entry.result) {
    case Ballot::chosen:
      return "chosen";
    case Ballot::beaten:
      return "beaten";
    case Ballot::unbalanced:
      return "unbalanced";
    case Ballot::redundant:
      return "cuts many";
    case Ballot::undividing:
      return "no gain";
    case Ballot::unconfirmed:
      return "sample only";
    case Ballot::overruled:
      return "overruled";
  }
  return "";
}

void draw_ballot(PanelContext& context) {
  DebuggerModel& model = context.model;
  const auto& ballot = model.run().ballot();
  if (ballot.empty()) {
    model.hovered_candidate.reset();
    ImGui::TextWrapped(
        "%s",
        "An operator that places a partitioner chooses among candidates. Go to a split, a shift-split or a "
        "balance in the list of events: here they all stand, with the reason why each was refused.");
    return;
  }
  if (context.memory.ballot_of != model.run().position()) context.memory.kept_candidate.reset();
  context.memory.ballot_of = model.run().position();
  ImGui::Text("%s of %s", counted(ballot.size(), "candidate").c_str(),
              to_string(model.run().position(), model.run().names()).c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("hover one: its plane is drawn");
  const auto hovered = draw_table(context, ballot);
  model.hovered_candidate = hovered                         ? hovered
                            : context.memory.kept_candidate ? context.memory.kept_candidate
                                                            : model.run().candidate();
  const std::size_t shown = model.hovered_candidate.value_or(0);
  ImGui::TextDisabled("objects on the direction of %zu: left, cut, right", shown);
  draw_strip(model.run().strip(std::min(shown, ballot.size() - 1)));
}

}  // namespace kerf

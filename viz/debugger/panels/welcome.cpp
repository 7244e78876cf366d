#include <algorithm>
#include <array>
#include <span>

#include "core/base/counted.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"
#include "viz/draw/story.h"

namespace kerf {
namespace {

/// A mark of the legend: how it looks, and what it stands for.
enum class Mark : std::uint8_t { filled, framed, line, error };
struct LegendRow {
  Mark mark;
  Color color;
  const char* text;
};
/// In 2D objects must stand out from the areas of the leaves, which have the colours.
constexpr std::array kFlatRows{
    LegendRow{Mark::filled, palette::kMoving, "object: blue, or in the colour it was given"},
    LegendRow{Mark::filled, Color{144, 200, 198}, "area of a leaf (see colour)"}};
constexpr std::array kSolidRows{
    LegendRow{Mark::filled, Color{33, 144, 141}, "object, coloured as its leaf (see colour)"}};

constexpr std::array kLegendRows{
    LegendRow{Mark::filled, palette::kStraddler, "straddler: it lies in several leaves"},
    LegendRow{Mark::filled, palette::kFixed, "fixed object"},
    LegendRow{Mark::framed, palette::kPartitioner, "partitioner: it divides its node's objects"},
    LegendRow{Mark::line, palette::kCandidate, "pair: the boxes of two objects overlap"},
    LegendRow{Mark::framed, palette::kOperator, "where the last operator acted; a selected object"},
    LegendRow{Mark::framed, palette::kSelected, "selected node"},
    LegendRow{Mark::framed, palette::kInk, "node under the mouse"}};

/// Of an import: what the other engine got wrong.
constexpr std::array kErrorRows{
    LegendRow{Mark::error, palette::kMissed, "error: an overlap that the other engine missed"},
    LegendRow{Mark::error, palette::kExtra, "error: the other engine reported what is no pair"}};

/// While a query is asked.
constexpr std::array kQueryRows{
    LegendRow{Mark::framed, palette::kSelected, "bounds of a node that the query visited"},
    LegendRow{Mark::framed, palette::kFaintInk, "dashed: bounds of a node that it pruned"},
    LegendRow{Mark::framed, palette::kOperator, "what it found"}};

void draw_mark(PanelContext& context, const LegendRow& row) {
  constexpr float kWide = 16;
  constexpr float kHigh = 11;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 a{at.x, at.y + 2};
  const ImVec2 b{at.x + kWide, at.y + 2 + kHigh};
  const ImU32 color = widgets::to_imgui(row.color);
  if (row.mark == Mark::filled) {
    list.AddRectFilled(a, b, color);
    list.AddRect(a, b, widgets::to_imgui(palette::kFaintInk));
  } else if (row.mark == Mark::framed) {
    list.AddRectFilled(a, b, widgets::to_imgui(row.color, 0.2));
    list.AddRect(a, b, color, 0, 0, 2);
  } else if (row.mark == Mark::error) {
    widgets::draw_error_sample({a.x, 0.5F * (a.y + b.y)}, row.color);
  } else {
    list.AddLine({a.x, 0.5F * (a.y + b.y)}, {b.x, 0.5F * (a.y + b.y)}, color, 2);
  }
  ImGui::Dummy({kWide + 6, kHigh});
  ImGui::SameLine(0, 0);
  widgets::text_within(context.gui, row.text, palette::kInk, ImGui::GetContentRegionAvail().x);
}

void draw_row(PanelContext& context, const LegendRow& row) {
  draw_mark(context, row);
  context.gui.note_last_item(row.text);
}

/// Within a step the pairs are those of the step before.
std::string overlapping(const Run& run) {
  const std::size_t pairs = run.pairs().size();
  if (run.position().is_end()) return counted(pairs, "pair overlaps", "pairs overlap");
  return counted(pairs, "pair") + " overlapped after step " + run.names().step(run.ended_step());
}

/// What is seen at this moment, in three sentences.
std::array<std::string, 3> sentences(Run& run) {
  const TreeSnapshot& tree = run.tree();
  std::uint32_t deepest = 0;
  for (const TreeSnapshot::Node& node : tree.nodes())
    if (node.alive) deepest = std::max(deepest, node.depth);
  const std::uint64_t objects = run.objects();
  const std::uint64_t all = objects * (objects > 0 ? objects - 1 : 0) / 2;
  return {"Step " + run.names().step(run.position().step) + " of " + counted(run.steps(), "step") + ": " +
              counted(run.objects(), "object") + ", each in a box, of which " + overlapping(run) + ".",
          "The tree has " + counted(tree.leaves(), "leaf", "leaves") + ", down to depth " +
              std::to_string(deepest) + "; only boxes that share a leaf are tested, not all " +
              with_commas(all) + " pairs.",
          "Space plays on; a click on an object, a plane or a bar says why it is so."};
}

/// What the other engine did with a pair, if that is wrong or undecided.
std::string error_words(Run& run, const Selection& pair) {
  if (run.their_judgement() == nullptr) return "";
  const auto is_in = [&](const std::vector<Pair>& pairs) {
    return std::ranges::any_of(pairs, [&](const Pair& wrong) { return Selection(wrong) == pair; });
  };
  if (is_in(run.their_judgement()->missed)) return ": missed by the other engine";
  if (is_in(run.their_judgement()->undecided)) return ": undecided, it touches only in the digits written";
  return is_in(run.their_judgement()->extra) ? ": reported by the other engine, and no overlap" : "";
}

}  // namespace

void draw_welcome(PanelContext& context) {
  if (!context.memory.welcome) return;
  auto place = context.gui.find("panel why");
  if (!place) place = context.gui.find("panel view");
  if (!place) return;
  ImGui::SetNextWindowPos({place->x, place->y}, ImGuiCond_Always);
  ImGui::SetNextWindowSize({place->width, 0});
  constexpr auto kFlags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  const std::string title = context.model.run().info().scene + "###welcome";
  if (ImGui::Begin(title.c_str(), &context.memory.welcome, kFlags)) {
    for (const std::string& sentence : sentences(context.model.run())) widgets::wrapped_text(sentence);
    ImGui::Spacing();
    const bool is_flat = context.model.run().info().dimension == 2;
    for (const LegendRow& row : is_flat ? std::span<const LegendRow>(kFlatRows) : kSolidRows)
      draw_row(context, row);
    for (const LegendRow& row : kLegendRows) draw_row(context, row);
    if (!context.model.view.query.empty())
      for (const LegendRow& row : kQueryRows) draw_mark(context, row);
    if (context.model.run().has_theirs())
      for (const LegendRow& row : kErrorRows) {
        draw_mark(context, row);
        context.gui.name_last_item(row.color == palette::kMissed ? "legend missed" : "legend extra",
                                   row.text);
      }
    ImGui::Spacing();
    if (widgets::button(context.gui, "tour", "seven stops, each with a look at this run", "welcome tour"))
      context.memory.tour = 0;
    ImGui::SameLine();
    if (widgets::button(context.gui, "close", "G shows it again", "close welcome"))
      context.memory.welcome = false;
  }
  ImGui::End();
}

std::string thing_words(Run& run, const Selection& thing) {
  const std::string name = run.title(thing);
  if (const auto node = node_in(thing))
    return run.tree().is_alive(*node) ? name + " " + node_words(run.tree(), *node) : name;
  const auto object = object_in(thing);
  if (!object) return name + error_words(run, thing);
  std::size_t pairs = 0;
  for (const Pair& pair : run.pairs()) pairs += pair.a == *object || pair.b == *object ? 1U : 0U;
  return name + ": " + counted(pairs, "pair") + run.note_on_pairs();
}

}  // namespace kerf

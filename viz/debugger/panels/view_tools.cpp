#include <imgui_internal.h>

#include <algorithm>
#include <array>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"
#include "viz/draw/structure_draw.h"

namespace kerf {
namespace {

constexpr std::array kLayers{Layer::objects, Layer::partitioners, Layer::leaves, Layer::pairs,
                             Layer::operators};

constexpr float kTintChoice = 105;
constexpr float kStructureChoice = 145;
constexpr float kDepths = 110;

// Units around the lines of text on the scene.
constexpr float kAboveTitle = 6;
constexpr float kBetweenLines = 4;
constexpr float kBelowCounts = 4;

float line_height() { return ImGui::GetTextLineHeight() + 2; }
float text_width(const char* text) { return ImGui::CalcTextSize(text).x; }

void draw_layers(PanelContext& context) {
  for (const Layer layer : kLayers) {
    bool shown = context.model.view.layers.has(layer);
    const std::string name(to_string(layer));
    const float width =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + text_width(name.c_str());
    if (layer != kLayers.front()) widgets::beside_or_below(width);
    if (widgets::checkbox(context.gui, name.c_str(), shown)) context.model.view.layers.set(layer, shown);
  }
}

/// Of an import with another engine's structure.
void draw_structure_choice(PanelContext& context) {
  if (!context.model.run().has_their_structure()) return;
  bool& theirs = context.model.view.theirs;
  widgets::beside_or_below(kStructureChoice);
  ImGui::SetNextItemWidth(kStructureChoice);
  const bool open = ImGui::BeginCombo("##structure", theirs ? "structure: theirs" : "structure: ours");
  context.gui.name_last_item("structure");
  widgets::hint("our tree, or the nodes of the other engine, with what is wrong with them");
  if (!open) return;
  if (widgets::row(context.gui, "ours", "structure ours", !theirs)) theirs = false;
  if (widgets::row(context.gui, "theirs", "structure theirs", theirs)) theirs = true;
  ImGui::EndCombo();
}

void draw_tint(PanelContext& context) {
  ViewSettings& settings = context.model.view;
  widgets::beside_or_below(text_width("colour") + ImGui::GetStyle().ItemSpacing.x + kTintChoice);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("colour");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(kTintChoice);
  const bool open = ImGui::BeginCombo("##colour", kTintNames[static_cast<std::size_t>(settings.tint)].data());
  context.gui.name_last_item("colour");
  if (!open) return;
  for (std::size_t k = 0; k < kTintNames.size(); ++k) {
    const std::string name(kTintNames[k]);
    if (widgets::row(context.gui, name, "colour " + name, static_cast<std::size_t>(settings.tint) == k))
      settings.tint = static_cast<Tint>(k);
  }
  ImGui::EndCombo();
}

std::string tint_scale(Tint tint, double end) {
  switch (tint) {
    case Tint::population:
      return "objects in the leaf: 0 to " + number_text(end) + "+";
    case Tint::balance:
      return "balance of the partitioner above the leaf: 0 to 1";
    case Tint::redundancy:
      return "straddlers of the partitioner above: 0 to 10 % and more";
    case Tint::cost:
      return "pairs a sweep may look at: 0 to " + number_text(end);
    case Tint::age:
      return "steps since an operator acted above: 0 to 100 and more";
  }
  return "";
}

std::string their_text(const ShownCounts& counts) {
  if (counts.their_nodes == 0) return "their structure is not known after this step";
  return "theirs: " + counted(counts.their_nodes, "node") + ", " + counted(counts.their_faults, "fault");
}

std::string not_alone_text(const ViewSettings& settings) {
  return "alone: " + node_text(*settings.isolated) + " is not alive here, so all is shown";
}

/// How many of each kind are drawn. Without room for all of it: of what is left out, else of the objects.
std::string counts_text(const ShownCounts& counts, float width) {
  std::string all;
  std::string left_out;
  const auto add = [](std::string& text, const std::string& share) {
    text += (text.empty() ? "" : ", ") + share;
  };
  const auto tell = [&](std::size_t shown, std::size_t there, const std::string& of) {
    const std::string share = std::to_string(shown) + " of " + std::to_string(there) + of;
    add(all, share);
    if (shown != there) add(left_out, share);
  };
  tell(counts.objects, counts.all_objects, " objects");
  const std::string objects = all;
  if (!counts.theirs) tell(counts.partitioners, counts.all_partitioners, " partitioners");
  tell(counts.pairs, counts.all_pairs, " pairs" + counts.pairs_note);
  all += " drawn";
  if (text_width(all.c_str()) <= width) return all;
  return widgets::elided((left_out.empty() ? objects : left_out) + " drawn", width);
}

void draw_text_on(ImDrawList& list, ImVec2 at, const std::string& text, Color color) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + size.x + 3, at.y + size.y + 1},
                     widgets::to_imgui(widgets::theme().scene, 0.93), 3);
  list.AddText(at, widgets::ink(color), text.c_str());
}

/// Above its subject, but within the view.
ImVec2 label_place(const SceneLabel& label, const ImVec2& size, const PanelArea& area, double scale) {
  const float x = label.x / static_cast<float>(scale);
  const float y = label.y / static_cast<float>(scale);
  return {area.x + std::clamp(x + 4, 4.0F, area.width - size.x - 6),
          area.y + std::clamp(y - 16, 4.0F, area.height - size.y - 4)};
}

/// Each where it belongs, or below those that it would cover.
void draw_scene_labels(ImDrawList& list, const std::vector<SceneLabel>& labels, const PanelArea& area,
                       double scale) {
  const float row = ImGui::GetTextLineHeight() + kBetweenLines;
  std::vector<ImRect> taken;
  for (const SceneLabel& label : labels) {
    const std::string text = widgets::elided(label.text, area.width - 16);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImVec2 at = label_place(label, size, area, scale);
    const auto place = [&] { return ImRect(at.x - 3, at.y - 1, at.x + size.x + 3, at.y + size.y + 1); };
    const auto covers = [&](const ImRect& other) { return place().Overlaps(other); };
    for (std::size_t k = 0; k < labels.size() && std::ranges::any_of(taken, covers); ++k) at.y += row;
    taken.push_back(place());
    draw_text_on(list, at, text, palette::kOperator);
  }
}

/// How many errors of another engine are drawn, below the title.
void draw_error_counts(ImDrawList& list, const ShownCounts& counts, ImVec2 at) {
  for (const bool missed : {true, false}) {
    const std::size_t count = missed ? counts.missed : counts.extra;
    if (count == 0) continue;
    draw_text_on(list, {at.x + 22, at.y}, std::to_string(count) + (missed ? " missed" : " extra"),
                 palette::kInk);
    widgets::draw_error_sample({at.x, at.y + 7}, missed ? palette::kMissed : palette::kExtra);
    at.y += ImGui::GetTextLineHeight() + 4;
  }
}

}  // namespace

void draw_view_tools(PanelContext& context) {
  DebuggerModel& model = context.model;
  draw_layers(context);
  draw_tint(context);
  ViewSettings& settings = model.view;
  if (widgets::button(context.gui, "focus", "look at what is selected, or at everything (F)"))
    context.view.focus(model.selection());
  ImGui::SameLine();
  if (widgets::button(context.gui, "hide", "hide what is selected, or show it again (H)"))
    model.toggle_hidden();
  ImGui::SameLine();
  if (widgets::button(context.gui, "alone", "only what is below the selected node (I)"))
    model.toggle_isolated();
  ImGui::SameLine();
  if (widgets::button(context.gui, "show all", "nothing hidden, nothing alone")) model.show_all();
  widgets::beside_or_below(text_width("legend") + 2 * ImGui::GetStyle().FramePadding.x);
  if (widgets::button(context.gui, "legend", "what is seen, in words, and what colours mean (G)"))
    context.memory.welcome = !context.memory.welcome;
  widgets::beside_or_below(text_width("depth") + ImGui::GetStyle().ItemSpacing.x + kDepths);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("depth");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(kDepths);
  ImGui::DragIntRange2("##depth", &settings.least_depth, &settings.greatest_depth, 0.2F, 0,
                       static_cast<int>(kMaxHeight), "%d to", "%d");
  context.gui.name_last_item("depth");
  widgets::hint("drag: partitioners of these depths are drawn; the root has depth 0");
  draw_structure_choice(context);
}

float overlay_above() { return kAboveTitle + 2 * line_height() + kBetweenLines; }
float overlay_below() { return kBelowCounts + 2 * line_height() + kBetweenLines; }

void draw_view_overlay(PanelContext& context, const SceneView& view, const PanelArea& area,
                       const std::string& title) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({area.x, area.y}, {area.x + area.width, area.y + area.height}, true);
  const float line = line_height();
  const float bottom = area.y + area.height - kBelowCounts;
  const ShownCounts& counts = view.counts();
  const bool all = counts.objects == counts.all_objects && counts.partitioners == counts.all_partitioners &&
                   counts.pairs == counts.all_pairs;
  draw_text_on(list, {area.x + 8, bottom - line}, counts_text(counts, area.width - 16),
               all ? palette::kFaintInk : palette::kCandidate);
  float top = area.y + kAboveTitle;
  for (const std::string& text :
       {title, counts.theirs ? their_text(counts) : "",
        counts.lacks_isolated ? not_alone_text(context.model.view) : "", counts.query}) {
    if (text.empty()) continue;
    draw_text_on(list, {area.x + 8, top}, widgets::elided(text, area.width - 24), palette::kInk);
    top += line + kBetweenLines;
  }
  draw_error_counts(list, counts, {area.x + 8, top});
  const ViewSettings& settings = context.model.view;
  if (settings.layers.has(Layer::leaves)) {
    const float above = bottom - 2 * line - kBetweenLines;
    for (int k = 0; k < 60; ++k)
      list.AddRectFilled({area.x + 8 + static_cast<float>(k), above + 2},
                         {area.x + 9 + static_cast<float>(k), above + 13},
                         widgets::to_imgui(palette::population_color(static_cast<std::uint32_t>(k), 60)));
    std::string scale = counts.theirs
                            ? "objects in the node: 1 to " + std::to_string(kFullCell) + "+, logarithmic"
                            : tint_scale(settings.tint, counts.tint_end);
    if (text_width(scale.c_str()) > area.width - 82) scale.erase(0, scale.find(':') + 2);  // its numbers
    draw_text_on(list, {area.x + 74, above}, scale, palette::kFaintInk);
  }
  draw_scene_labels(list, view.labels(), area, context.gui.scale());
  list.PopClipRect();
}

}  // namespace kerf

#include <algorithm>
#include <cmath>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/contrast.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kHighestBar = 18;  // pixels
constexpr float kNamedBar = 6;     // width from which a script finds a bar by its name
constexpr float kSeenBar = 2;      // least width of a marked one
constexpr float kNameHeight = 13;

/// Where the bars are.
struct IcicleGrid {
  PanelArea area;
  float row = 1;  ///< height of a bar

  [[nodiscard]] PanelArea place(const IcicleBar& bar) const {
    const float left = area.x + static_cast<float>(bar.left) * area.width;
    const float right = area.x + static_cast<float>(bar.right) * area.width;
    const float top = area.y + row * static_cast<float>(bar.depth);
    return {left, top, right - left, row};
  }
};

/// Of bars that share a column of pixels, the first one is drawn: a tree may have more leaves than pixels.
std::vector<const IcicleBar*> bars_seen(const IcicleState& icicle, const IcicleGrid& grid) {
  std::vector<const IcicleBar*> seen;
  std::vector<float> drawn_to(icicle.rows, -1);
  for (const IcicleBar& bar : icicle.bars) {
    const PanelArea place = grid.place(bar);
    const float end = std::ceil(place.x + place.width);
    if (end <= drawn_to[bar.depth]) continue;
    drawn_to[bar.depth] = end;
    seen.push_back(&bar);
  }
  return seen;
}

void frame_bar(const PanelArea& place, Color color, float width) {
  const float right = place.x + std::max(place.width, kSeenBar);
  ImGui::GetWindowDrawList()->AddRect({place.x, place.y}, {right, place.y + place.height},
                                      widgets::to_imgui(color), 0, 0, width);
}

/// White or black letters: those with more contrast.
Color ink_on(Color ground) {
  constexpr Color kWhite{255, 255, 255};
  return contrast(kWhite, ground) > contrast(palette::kInk, ground) ? kWhite : palette::kInk;
}

void fill_bar(PanelContext& context, const IcicleBar& bar, const PanelArea& place, Color color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float gap_x = place.width >= 4 ? 1.0F : 0.0F;
  const float gap_y = place.height >= 4 ? 1.0F : 0.0F;
  list.AddRectFilled({place.x, place.y},
                     {place.x + std::max(1.0F, place.width - gap_x), place.y + place.height - gap_y},
                     widgets::to_imgui(color));
  const std::string name = "n" + std::to_string(bar.node.value);
  const bool has_room = place.height >= kNameHeight && ImGui::CalcTextSize(name.c_str()).x + 4 <= place.width;
  if (has_room)
    list.AddText({place.x + 3, place.y + std::floor(0.5F * (place.height - 15))},
                 widgets::exactly(ink_on(widgets::theme().mark(color))), name.c_str());
  if (place.width >= kNamedBar) context.gui.name_area("bar " + name, place);
}

/// The colour of the scene, mixed with that of operators where one acted lately.
class IcicleColors {
 public:
  IcicleColors(PanelContext& context, const IcicleState& icicle) : icicle_(icicle) {
    const Tint tint = context.model.view.tint;
    Run& run = context.model.run();
    tints_ = &context.view.tints(tint);
    end_ = std::max(context.view.counts().tint_end, tints_->end);
    if (!icicle.last) return;
    const TreeSnapshot& tree = tree_of(icicle, run);
    const Position before{icicle.last->step, icicle.last->event - 1};
    const auto changes = last_changes(run.operators(), before, tree.nodes().size());
    own_ = find_tints({tree, before.step, changes}, tint);
    tints_ = &own_;
  }
  [[nodiscard]] Color color(NodeId node) const {
    if (icicle_.acted == node) return palette::kOperator;
    const auto recent = icicle_.recent.find(node);
    const double strength = recent == icicle_.recent.end() ? 0 : 0.75 * recent->second;
    return mix(tints_->color(node, end_), widgets::theme().mark(palette::kOperator), strength);
  }

 private:
  const IcicleState& icicle_;
  const NodeTints* tints_ = nullptr;
  NodeTints own_;
  double end_ = 1;
};

/// A marked bar that shares its pixels with others is drawn nevertheless.
void mark_bars(PanelContext& context, const IcicleState& icicle, const IcicleGrid& grid) {
  for (const IcicleBar& bar : icicle.bars) {
    const PanelArea place = grid.place(bar);
    if (icicle.acted == bar.node) {
      fill_bar(context, bar, place, palette::kOperator);
      frame_bar(place, palette::kOperator, 1);
    }
    if (icicle.selected.contains(bar.node)) frame_bar(place, palette::kSelected, 2);
    if (context.model.hovered_node == bar.node) frame_bar(place, palette::kInk, 1);
  }
}

const IcicleBar* bar_under(const IcicleState& icicle, const IcicleGrid& grid, const ImVec2& mouse) {
  for (const IcicleBar& bar : icicle.bars) {
    const PanelArea place = grid.place(bar);
    if (mouse.x >= place.x && mouse.x < place.x + place.width && mouse.y >= place.y &&
        mouse.y < place.y + place.height)
      return &bar;
  }
  return nullptr;
}

/// Selects and hovers as the outline does.
void use_icicle(PanelContext& context, const IcicleState& icicle, const IcicleGrid& grid) {
  ImGui::SetCursorScreenPos({grid.area.x, grid.area.y});
  const bool pressed = ImGui::InvisibleButton("icicle", {grid.area.width, grid.area.height});
  context.gui.name_last_item("icicle");
  if (!ImGui::IsItemHovered() && !pressed) return;
  const IcicleBar* const bar = bar_under(icicle, grid, ImGui::GetIO().MousePos);
  if (bar == nullptr) return;
  const TreeSnapshot& tree = tree_of(icicle, context.model.run());
  context.memory.hovered_node = bar->node;
  const std::string text = "n" + std::to_string(bar->node.value) + ", depth " + std::to_string(bar->depth) +
                           "\n" + node_words(tree, bar->node);
  ImGui::SetTooltip("%s", text.c_str());
  if (pressed) context.model.select(bar->node);
}

/// What the tree is of, in as many words as fit.
std::string heading_of(const IcicleState& icicle, bool before, float room) {
  const std::string plain = "by population";
  if (!before) return ImGui::CalcTextSize(plain.c_str()).x <= room ? plain : "";
  if (!icicle.last) return "no operator yet";
  const std::string text = "before e" + std::to_string(icicle.last->event);
  const std::string more = text + " " + std::string(to_string(icicle.last->op)) + " n" +
                           std::to_string(icicle.last->node.node.value);
  return ImGui::CalcTextSize(more.c_str()).x <= room ? more : text;
}

void draw_heading_of_icicle(PanelContext& context, const IcicleState& icicle) {
  const bool before = context.memory.before_operator;
  const float box = ImGui::GetWindowWidth() - 92;
  ImGui::AlignTextToFramePadding();
  if (!before) ImGui::TextUnformatted("Icicle");
  if (!before) ImGui::SameLine();
  const std::string text = heading_of(icicle, before, box - ImGui::GetCursorPosX() - 4);
  ImGui::TextColored(widgets::to_vector(before ? palette::kOperator : palette::kFaintInk), "%s",
                     text.c_str());
  context.gui.note_last_item("icicle of");
  ImGui::SameLine(box);
  widgets::checkbox(context.gui, "before", context.memory.before_operator,
                    "the tree just before the last operator that acted (A)");
}

}  // namespace

void draw_icicle(PanelContext& context) {
  DebuggerModel& model = context.model;
  const IcicleState& icicle =
      context.memory.icicle.icicle(model.run(), model.selection(), context.memory.before_operator);
  draw_heading_of_icicle(context, icicle);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (room.x < 1 || room.y < 1) return;
  const float row = std::min(kHighestBar, room.y / static_cast<float>(icicle.rows));
  const IcicleGrid grid{{origin.x, origin.y, room.x, room.y}, row >= 2 ? std::floor(row) : row};
  const IcicleColors colors(context, icicle);
  for (const IcicleBar* const bar : bars_seen(icicle, grid))
    fill_bar(context, *bar, grid.place(*bar), colors.color(bar->node));
  mark_bars(context, icicle, grid);
  use_icicle(context, icicle, grid);
}

}  // namespace kerf

#include <algorithm>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "core/tree/partitioner.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/debugger/panels/panel_menu.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr std::uint32_t kUnfolded = 3;  // depth down to which the tree is unfolded at first

bool is_unfolded(const PanelMemory& memory, const TreeSnapshot& tree, NodeId id) {
  return tree[id].depth < kUnfolded ? !memory.folded.contains(id) : memory.unfolded.contains(id);
}

void toggle_fold(PanelMemory& memory, const TreeSnapshot& tree, NodeId id) {
  auto& set = tree[id].depth < kUnfolded ? memory.folded : memory.unfolded;
  if (!set.erase(id)) set.insert(id);
}

/// Unfolds the tree down to the selection.
void unfold_to(PanelMemory& memory, const TreeSnapshot& tree, NodeId id) {
  for (NodeId above = tree[id].parent; !above.is_none(); above = tree[above].parent)
    if (!is_unfolded(memory, tree, above)) toggle_fold(memory, tree, above);
}

std::vector<NodeId> unfolded_rows(const PanelMemory& memory, const TreeSnapshot& tree) {
  std::vector<NodeId> rows;
  std::vector<NodeId> todo{tree.root()};
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    rows.push_back(id);
    if (tree[id].is_leaf() || !is_unfolded(memory, tree, id)) continue;
    todo.push_back(tree[id].right);
    todo.push_back(tree[id].left);
  }
  return rows;
}

/// The row of the node under the mouse in the icicle.
void mark_row() {
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()};
  ImGui::GetWindowDrawList()->AddRectFilled(least, {least.x + size.x, least.y + size.y},
                                            ImGui::GetColorU32(ImGuiCol_HeaderHovered));
}

void draw_row(PanelContext& context, const TreeSnapshot& tree, NodeId id) {
  DebuggerModel& model = context.model;
  const std::string name = "n" + std::to_string(id.value);
  const bool is_leaf = tree[id].is_leaf();
  const bool hidden = model.view.hidden_nodes.contains(id);
  const bool is_event = model.run().event_node() == id;
  ImGui::Dummy({static_cast<float>(tree[id].depth) * 9, 1});
  ImGui::SameLine(0, 0);
  ImGui::TextUnformatted(is_leaf ? "  " : is_unfolded(context.memory, tree, id) ? "- " : "+ ");
  if (!is_leaf && ImGui::IsItemClicked()) toggle_fold(context.memory, tree, id);
  context.gui.name_last_item("fold " + name);
  ImGui::SameLine(0, 0);
  const Theme& theme = widgets::theme();
  const auto& recent = context.memory.icicle.kept().recent;
  const auto found = recent.find(id);
  const Color ink = found == recent.end()
                        ? palette::kInk
                        : mix(theme.text(palette::kInk), theme.text(palette::kOperator), found->second);
  const Color color = is_event ? palette::kOperator : hidden ? palette::kFixed : ink;
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(color));
  const std::string marks =
      std::string(hidden ? " hidden" : "") + (model.view.isolated == id ? " alone" : "");
  if (model.hovered_node == id) mark_row();
  if (widgets::row(context.gui, name + " " + node_words(tree, id) + marks, name, model.is_selected(id)))
    model.select(id);
  if (ImGui::IsItemHovered()) context.memory.hovered_node = id;
  ImGui::PopStyleColor();
}

}  // namespace

std::string node_words(const TreeSnapshot& tree, NodeId id) {
  std::string text = std::to_string(tree[id].population);
  if (tree[id].is_leaf()) return "leaf " + text;
  const Quality quality = tree.quality(id);
  char figures[64];
  std::snprintf(figures, sizeof figures, "  bal %.2f  cut %u", double{balance(quality)}, redundancy(quality));
  return text + figures;
}

void draw_outline(PanelContext& context) {
  DebuggerModel& model = context.model;
  const TreeSnapshot& tree = model.run().tree();
  ImGui::TextUnformatted("Tree");
  ImGui::SameLine();
  const std::string counts =
      counted(tree.leaves(), "leaf", "leaves") + ", " + counted(model.run().objects(), "object");
  widgets::text_within(context.gui, counts, palette::kFaintInk, ImGui::GetContentRegionAvail().x - kMenuRoom);
  ImGui::BeginChild("outline", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
  const auto selected = node_in(model.selection());
  const bool is_new = context.memory.outlined != model.selection();
  const bool lives = selected && tree.is_alive(*selected);
  if (lives && is_new) unfold_to(context.memory, tree, *selected);
  const auto rows = unfolded_rows(context.memory, tree);
  const float height = ImGui::GetTextLineHeightWithSpacing();
  if (lives && is_new) {
    const auto row = static_cast<float>(std::ranges::find(rows, *selected) - rows.begin());
    const float top = row * height - ImGui::GetScrollY();
    if (top < 0 || top > ImGui::GetWindowHeight() - 2 * height)
      ImGui::SetScrollY(std::max(0.0F, row * height - 0.4F * ImGui::GetWindowHeight()));
  }
  context.memory.outlined = model.selection();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), height);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
      draw_row(context, tree, rows[static_cast<std::size_t>(k)]);
  ImGui::EndChild();
}

}  // namespace kerf

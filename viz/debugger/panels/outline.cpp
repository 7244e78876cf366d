#include <algorithm>

#include "core/query/text.h"
#include "core/tree/partitioner.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr std::uint32_t kUnfolded = 3;  // depth down to which the tree is unfolded at first

bool is_unfolded(const PanelMemory& memory, NodeId id, const TreeRow& row) {
  return row.depth < kUnfolded ? !memory.folded.contains(id) : memory.unfolded.contains(id);
}

void toggle_fold(PanelMemory& memory, NodeId id, const TreeRow& row) {
  auto& set = row.depth < kUnfolded ? memory.folded : memory.unfolded;
  if (!set.erase(id)) set.insert(id);
}

/// What is selected is unfolded down to it.
void unfold_to(PanelMemory& memory, std::span<const TreeRow> tree, NodeId id) {
  for (NodeId above = tree[id.index()].parent; !above.is_none(); above = tree[above.index()].parent)
    if (!is_unfolded(memory, above, tree[above.index()])) toggle_fold(memory, above, tree[above.index()]);
}

std::vector<NodeId> unfolded_rows(const PanelMemory& memory, std::span<const TreeRow> tree, NodeId root) {
  std::vector<NodeId> rows;
  std::vector<NodeId> todo{root};
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    rows.push_back(id);
    const TreeRow& row = tree[id.index()];
    if (row.is_leaf() || !is_unfolded(memory, id, row)) continue;
    todo.push_back(row.right);
    todo.push_back(row.left);
  }
  return rows;
}

std::string row_text(const TreeRow& row) {
  std::string text = std::to_string(row.population);
  if (row.is_leaf()) return text;
  char figures[64];
  std::snprintf(figures, sizeof figures, "  bal %.2f  cut %u", double{balance(row.quality)},
                redundancy(row.quality));
  return text + figures;
}

void draw_tree_row(PanelContext& context, NodeId id, const TreeRow& row) {
  DebuggerModel& model = context.model;
  const std::string name = "n" + std::to_string(id.value);
  const bool hidden = model.view.hidden_nodes.contains(id);
  const bool is_event = model.run().event_node() == id;
  ImGui::Dummy({static_cast<float>(row.depth) * 9, 1});
  ImGui::SameLine(0, 0);
  const char* const arrow = row.is_leaf() ? "  " : is_unfolded(context.memory, id, row) ? "- " : "+ ";
  ImGui::TextUnformatted(arrow);
  if (!row.is_leaf() && ImGui::IsItemClicked()) toggle_fold(context.memory, id, row);
  context.gui.name_last_item("fold " + name);
  ImGui::SameLine(0, 0);
  const Color color = is_event ? palette::kOperator : hidden ? palette::kFixed : palette::kInk;
  ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(color));
  const std::string marks =
      std::string(hidden ? " hidden" : "") + (model.view.isolated == id ? " alone" : "");
  if (widgets::row(context.gui, name + " " + (row.is_leaf() ? "leaf " : "") + row_text(row) + marks, name,
                   model.is_selected(id)))
    model.select(id);
  ImGui::PopStyleColor();
}

}  // namespace

void draw_outline(PanelContext& context) {
  DebuggerModel& model = context.model;
  const auto tree = model.run().tree();
  const auto leaves =
      std::ranges::count_if(tree, [](const TreeRow& row) { return row.alive && row.is_leaf(); });
  ImGui::TextUnformatted("Tree");
  ImGui::SameLine();
  ImGui::TextDisabled("%lld leaves, %u objects", static_cast<long long>(leaves), model.run().objects());
  ImGui::BeginChild("outline", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
  const auto* const selected = std::get_if<NodeId>(&model.selection());
  const bool is_new = context.memory.outlined != model.selection();
  const bool lives = selected != nullptr && selected->index() < tree.size() && tree[selected->index()].alive;
  if (lives && is_new) unfold_to(context.memory, tree, *selected);
  const auto rows = unfolded_rows(context.memory, tree, model.run().root());
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
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const NodeId id = rows[static_cast<std::size_t>(k)];
      draw_tree_row(context, id, tree[id.index()]);
    }
  ImGui::EndChild();
}

}  // namespace kerf

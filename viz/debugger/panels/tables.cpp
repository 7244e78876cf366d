#include <algorithm>

#include "core/base/counted.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {
namespace {

constexpr auto kTableFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                             ImGuiTableFlags_BordersOuter | ImGuiTableFlags_BordersInnerV |
                             ImGuiTableFlags_SizingStretchProp;

/// One of two tables.
void draw_choice(PanelContext& context, const char* label, bool pairs) {
  const ImVec2 size{ImGui::CalcTextSize(label).x, ImGui::GetTextLineHeight()};
  ImGui::AlignTextToFramePadding();
  if (ImGui::Selectable(label, context.memory.lists_pairs == pairs, 0, size))
    context.memory.lists_pairs = pairs;
  context.gui.name_last_item(std::string("table ") + label, label);
  ImGui::SameLine(0, 10);
}

void copy_table(PanelContext& context) {
  PanelMemory& memory = context.memory;
  memory.copied = to_csv(memory.table.table(), memory.table.rows());
  memory.to_clipboard = memory.copied;
  context.model.message = "copied " + counted(memory.table.rows().size(), "row") + " as CSV";
  context.model.message_is_error = false;
}

void draw_tools_of_table(PanelContext& context) {
  constexpr float kCopy = 68;
  draw_choice(context, "nodes", false);
  draw_choice(context, "pairs", true);
  const float width = ImGui::GetContentRegionAvail().x - kCopy;
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  widgets::text_field(context.gui, "find in table", context.memory.table_filter,
                      context.memory.lists_pairs ? "12, 12,77 or n5" : "n17, 17 or leaf", width);
  ImGui::PopStyleVar();
  ImGui::SameLine();
  if (widgets::button(context.gui, "copy CSV", "the rows below, for a spreadsheet", "copy table"))
    copy_table(context);
}

/// A click on a header orders by its column; a second one turns the order round.
void draw_headers(PanelContext& context, const FigureTable& table, TableOrder& order) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const int most_first =
        k == 0 ? ImGuiTableColumnFlags_DefaultSort : ImGuiTableColumnFlags_PreferSortDescending;
    ImGui::TableSetupColumn(table.columns[k].c_str(), most_first);
  }
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    ImGui::TableSetColumnIndex(static_cast<int>(k));
    ImGui::TableHeader(table.columns[k].c_str());
    context.gui.name_last_item("sort " + table.columns[k], table.columns[k]);
  }
  const ImGuiTableSortSpecs* const wanted = ImGui::TableGetSortSpecs();
  if (wanted == nullptr || wanted->SpecsCount == 0) return;
  order.column = static_cast<std::size_t>(wanted->Specs->ColumnIndex);
  order.falling = wanted->Specs->SortDirection == ImGuiSortDirection_Descending;
}

void draw_table_row(PanelContext& context, std::size_t row) {
  const FigureTable& table = context.memory.table.table();
  const FigureTable::Row& of = table.rows[row];
  DebuggerModel& model = context.model;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool pressed = ImGui::Selectable((of.name + "##row").c_str(), model.selection() == of.item,
                                         ImGuiSelectableFlags_SpanAllColumns);
  context.gui.name_last_item("row " + of.name);
  const auto node = node_in(of.item);
  if (node && ImGui::IsItemHovered()) context.memory.hovered_node = *node;
  for (std::size_t column = 1; column < table.columns.size(); ++column) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell_text(table, row, column).c_str());
  }
  if (pressed) model.select(of.item);
}

/// Scrolls to what has been selected elsewhere.
void follow_selection(PanelContext& context, float row_height) {
  const TableKeeper& kept = context.memory.table;
  const Selection& selection = context.model.selection();
  if (context.memory.tabled == selection) return;
  context.memory.tabled = selection;
  const auto found = std::ranges::find(kept.rows(), selection, [&](std::size_t row) -> const Selection& {
    return kept.table().rows[row].item;
  });
  if (found == kept.rows().end()) return;
  const float top = row_height * static_cast<float>(found - kept.rows().begin());
  const float seen = ImGui::GetScrollY();
  const float room = ImGui::GetWindowHeight() - 2 * row_height;
  if (top < seen || top > seen + room - row_height) ImGui::SetScrollY(std::max(0.0F, top - 0.4F * room));
}

}  // namespace

void draw_tables(PanelContext& context) {
  PanelMemory& memory = context.memory;
  TableOrder& order = memory.table_order[memory.lists_pairs ? 1 : 0];
  memory.table.update(context.model.run(), {memory.lists_pairs, memory.table_filter, order});
  draw_tools_of_table(context);
  const FigureTable& table = memory.table.table();
  const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  if (!ImGui::BeginTable(table.columns[0].c_str(), static_cast<int>(table.columns.size()), kTableFlags))
    return;
  draw_headers(context, table, order);
  follow_selection(context, height);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(memory.table.rows().size()), height);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
      draw_table_row(context, memory.table.rows()[static_cast<std::size_t>(k)]);
  ImGui::EndTable();
}

}  // namespace kerf

#include <algorithm>
#include <array>

#include "core/base/counted.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr auto kTableFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                             ImGuiTableFlags_BordersOuter | ImGuiTableFlags_BordersInnerV |
                             ImGuiTableFlags_SizingStretchProp;

/// What can be typed to find rows, by what the table lists.
constexpr std::array kFindHints{"n17, 17 or leaf", "12, 12,77 or n5", "12, moving or fixed",
                                "12, 12,77 or missed"};

void draw_choice(PanelContext& context, TableOf of) {
  const char* const label = kTableNames[static_cast<std::size_t>(of)].data();
  const ImVec2 size{ImGui::CalcTextSize(label).x, ImGui::GetTextLineHeight()};
  ImGui::AlignTextToFramePadding();
  if (ImGui::Selectable(label, context.memory.table_of == of, 0, size)) context.memory.table_of = of;
  context.gui.name_last_item(std::string("table ") + label, label);
  ImGui::SameLine(0, 10);
}

void copy_table(PanelContext& context) {
  const TableKeeper& kept = context.memory.table;
  put_into_clipboard(context, to_csv(to_texts(kept.table(), kept.rows())),
                     counted(kept.rows().size(), "row") + " as CSV");
}

void draw_tools_of_table(PanelContext& context) {
  constexpr float kCopy = 68;
  draw_choice(context, TableOf::nodes);
  draw_choice(context, TableOf::pairs);
  draw_choice(context, TableOf::objects);
  if (context.model.run().has_theirs()) draw_choice(context, TableOf::errors);
  const float width = ImGui::GetContentRegionAvail().x - kCopy;
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  widgets::text_field(context.gui, "find in table", context.memory.table_filter,
                      kFindHints[static_cast<std::size_t>(context.memory.table_of)], width);
  ImGui::PopStyleVar();
  ImGui::SameLine();
  if (widgets::button(context.gui, "copy CSV", "the rows below, for a spreadsheet", "copy table"))
    copy_table(context);
}

/// What a reader must know of the rows below.
void draw_note_on_rows(PanelContext& context, TableOf of) {
  Run& run = context.model.run();
  const std::size_t rows = context.memory.table.table().rows.size();
  if (of == TableOf::errors && rows < run.wrong_pairs().size())
    ImGui::TextDisabled("the first %zu of %zu errors", rows, run.wrong_pairs().size());
  if ((of != TableOf::pairs && of != TableOf::objects) || run.position().is_end()) return;
  const std::string note = "pairs" + run.note_on_pairs() + ", boxes of this moment";
  ImGui::TextDisabled("%s%s", note.c_str(), of == TableOf::pairs ? "; -: apart now" : "");
  context.gui.note_last_item(note);
}

/// A click on a header orders by its column; a second one turns the order round.
void draw_headers(PanelContext& context, const FigureTable& table, TableOrder& order) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const bool most_first = k > 0 && context.memory.table_of != TableOf::errors;
    ImGui::TableSetupColumn(table.columns[k].c_str(),
                            (k == order.column ? ImGuiTableColumnFlags_DefaultSort : 0) |
                                (most_first ? ImGuiTableColumnFlags_PreferSortDescending : 0));
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
  ImGui::PushID(static_cast<int>(row));  // a pair can be wrong in many steps
  const bool selected = of.wrong_pair ? model.wrong_pair() == of.wrong_pair : model.selection() == of.item;
  const bool pressed =
      ImGui::Selectable((of.name + "##row").c_str(), selected, ImGuiSelectableFlags_SpanAllColumns);
  ImGui::PopID();
  context.gui.name_last_item("row " + of.name +
                             (of.wrong_pair ? " at " + cell_text(table, row, 1) : std::string()));
  const auto node = node_in(of.item);
  if (node && ImGui::IsItemHovered()) context.memory.hovered_node = *node;
  for (std::size_t column = 1; column < table.columns.size(); ++column) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x;
    widgets::text_within(context.gui, cell_text(table, row, column), palette::kInk, room);
  }
  if (!pressed) return;
  if (!of.wrong_pair) return model.select(of.item);
  model.go_to_wrong_pair(*of.wrong_pair);
  context.view.focus(of.item);
}

/// The row of what is selected elsewhere, if that has changed since the table scrolled to it.
std::optional<std::size_t> row_to_follow(PanelContext& context) {
  PanelMemory& memory = context.memory;
  DebuggerModel& model = context.model;
  const TableKeeper& kept = memory.table;
  const bool errors = memory.table_of == TableOf::errors;
  const auto error = errors ? model.wrong_pair() : std::nullopt;
  if (memory.tabled == model.selection() && (!errors || memory.tabled_error == error)) return std::nullopt;
  memory.tabled = model.selection();
  if (errors) memory.tabled_error = error;
  const auto is_it = [&](std::size_t row) {
    const FigureTable::Row& of = kept.table().rows[row];
    return errors ? error && of.wrong_pair == error : of.item == model.selection();
  };
  const auto found = std::ranges::find_if(kept.rows(), is_it);
  if (found == kept.rows().end()) return std::nullopt;
  return static_cast<std::size_t>(found - kept.rows().begin());
}

/// Scrolls to what has been selected elsewhere.
void follow_selection(PanelContext& context, float row_height) {
  const auto row = row_to_follow(context);
  if (!row) return;
  const float top = row_height * static_cast<float>(*row);
  const float seen = ImGui::GetScrollY();
  const float room = ImGui::GetWindowHeight() - 2 * row_height;
  if (top < seen || top > seen + room - row_height) ImGui::SetScrollY(std::max(0.0F, top - 0.4F * room));
}

}  // namespace

void draw_tables(PanelContext& context) {
  PanelMemory& memory = context.memory;
  Run& run = context.model.run();
  if (memory.table_of == TableOf::errors && !run.has_theirs()) memory.table_of = TableOf::nodes;
  const auto of = static_cast<std::size_t>(memory.table_of);
  TableOrder& order = memory.table_order[of];
  memory.table.update(run, {memory.table_of, memory.table_filter, order});
  draw_tools_of_table(context);
  const FigureTable& table = memory.table.table();
  draw_note_on_rows(context, memory.table_of);
  const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  if (!ImGui::BeginTable(kTableNames[of].data(), static_cast<int>(table.columns.size()), kTableFlags)) return;
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

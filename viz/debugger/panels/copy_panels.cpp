#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/counted.h"
#include "core/base/shortest_text.h"
#include "core/query/text.h"
#include "core/tree/partitioner.h"
#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/model/algorithm_1.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel_menu.h"

namespace kerf {
namespace {

std::string whole(double number) { return shortest_text(number); }

/// The nodes as the outline has them, children below their parents.
TextTable table_of_tree(PanelContext& context) {
  const TreeSnapshot& tree = context.model.run().tree();
  TextTable table{{"node", "depth", "population", "balance", "cut"}, {}};
  std::vector<NodeId> todo{tree.root()};
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    const TreeSnapshot::Node& node = tree[id];
    std::vector<std::string> row{node_text(id), std::to_string(node.depth), std::to_string(node.population),
                                 "", ""};
    if (!node.is_leaf()) {
      row[3] = number_text(double{balance(tree.quality(id))});
      row[4] = std::to_string(redundancy(tree.quality(id)));
      todo.insert(todo.end(), {node.right, node.left});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

TextTable table_of_stops(PanelContext& context) {
  const DebuggerModel& model = context.model;
  TextTable table{{"kind", "what", "stops", "hits", "value", "note"}, {}};
  for (const Breakpoint& breakpoint : model.breakpoints)
    table.rows.push_back({"breakpoint", breakpoint.condition.text(), breakpoint.enabled ? "yes" : "no",
                          std::to_string(breakpoint.hits), "", ""});
  for (const WatchedValue& watch : model.watches())
    table.rows.push_back({"watch", watch.expression.text(),
                          !watch.stop                  ? "no"
                          : *watch.stop == Change::any ? "when it changes"
                                                       : "when it is true",
                          std::to_string(watch.hits), watch.value.exists() ? to_text(watch.value) : "", ""});
  for (const auto& [moment, note] : model.bookmarks)
    table.rows.push_back({"bookmark", to_string(moment, model.run().names()), "", "", "", note});
  return table;
}

TextTable table_of_events(PanelContext& context) {
  const GivenNames& names = context.model.run().names();
  TextTable table{{"event", "step", "what"}, {}};
  for (const Event* const event : listed_events(context))
    table.rows.push_back(
        {"e" + std::to_string(event->id), names.step(event->step), deed_text(*event, names)});
  return table;
}

TextTable table_of_ballot(PanelContext& context) {
  TextTable table{{"candidate", "plane", "left", "right", "balance", "cut", "score", "result"}, {}};
  const auto& ballot = context.model.run().ballot();
  for (std::size_t k = 0; k < ballot.size(); ++k) {
    const Quality& quality = ballot[k].entry.quality;
    table.rows.push_back({std::to_string(k), ballot[k].plane, std::to_string(quality.left),
                          std::to_string(quality.right), number_text(double{balance(quality)}),
                          std::to_string(redundancy(quality)), number_text(ballot[k].score),
                          result_word(ballot[k].entry)});
  }
  return table;
}

TextTable table_of_oracle(PanelContext& context) {
  Run& run = context.model.run();
  TextTable table{{"verdict", "object", "other object"}, {}};
  if (!context.model.alarms().contains(run.position().step)) return table;
  const auto add = [&](const char* verdict, const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs)
      table.rows.push_back({verdict, run.names().object(pair.a), run.names().object(pair.b)});
  };
  const PairJudgement& judgement = run.judgement();
  add("missed", judgement.missed);
  add("false", judgement.extra);
  add("twice", judgement.twice);
  add("ignored", judgement.ignored);
  add("undecided", judgement.undecided);
  return table;
}

TextTable table_of_comparison(PanelContext& context) {
  TextTable table{{"figure", "this run", "the other"}, {}};
  if (context.model.other() == nullptr) return table;
  for (const ComparedFigure& figure : compared_figures(context.model.comparison()))
    table.rows.push_back({figure.name, whole(figure.a), whole(figure.b)});
  return table;
}

TextTable table_of_findings(PanelContext& context) {
  const GivenNames& names = context.model.run().names();
  if (context.model.view.theirs) {
    TextTable faults{{"step", "steps", "what"}, {}};
    for (const TheirFault& fault : context.model.run().all_their_faults())
      faults.rows.push_back({names.step(fault.first_step), std::to_string(fault.steps), fault.fault.text});
    return faults;
  }
  TextTable table{{"event", "node", "what"}, {}};
  for (const Thrash& thrash : context.model.lint(static_cast<std::uint32_t>(context.memory.lint_within)))
    table.rows.push_back(
        {"e" + std::to_string(thrash.event), node_text(thrash.node), to_text(thrash, names)});
  return table;
}

/// The shown rows of the tables.
TextTable table_of_rows(PanelContext& context) {
  PanelMemory& memory = context.memory;
  memory.table.update(context.model.run(), {memory.table_of, memory.table_filter,
                                            memory.table_order[static_cast<std::size_t>(memory.table_of)]});
  return to_texts(memory.table.table(), memory.table.rows());
}

/// The parameters that can be changed, as they are now.
TextTable table_of_parameters(PanelContext& context) {
  TextTable table{{"parameter", "value", "least", "greatest", "meaning"}, {}};
  for (const ConfigField& field : config_fields())
    table.rows.push_back({std::string(field.name), get(context.model.run().config(), field.name),
                          whole(field.minimum), whole(field.maximum), std::string(field.meaning)});
  return table;
}

/// The objects of the scene, seen or not.
TextTable table_of_scene(PanelContext& context) {
  const FigureTable table = table_of_objects(context.model.run());
  return to_texts(table, find_rows(table, "", {}));
}

/// The steps that the lanes show.
TextTable table_of_lanes(PanelContext& context) {
  const DebuggerModel& model = context.model;
  TextTable table{{"step"}, {}};
  for (const Lane& lane : model.lanes()) table.columns.emplace_back(lane.name());
  const TimeWindow& window = model.timeline.window;
  const auto last = std::min(model.run().steps(), static_cast<std::uint32_t>(std::ceil(window.last())));
  for (auto step = static_cast<std::uint32_t>(window.first()) + 1; step <= last; ++step) {
    std::vector<std::string> row{model.run().names().step(step)};
    for (const Lane& lane : model.lanes()) {
      const auto value = lane.value(step);
      row.push_back(value ? number_text(*value) : "");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string text_of_moment(PanelContext& context) {
  const Run& run = context.model.run();
  return moment_words(run) + ", of " + counted(run.steps(), "step") + ", state " + to_hex(run.state_hash()) +
         "\n";
}

std::string text_of_algorithm(PanelContext& context) {
  const Algorithm1Trace trace = trace_algorithm_1(context.model.run());
  std::string text;
  for (std::size_t k = 0; k < kAlgorithm1.size(); ++k) {
    text += (trace.line == static_cast<int>(k) + 1 ? "> " : "  ") + std::string(kAlgorithm1[k]) + "\n";
    if (!trace.decided[k].empty()) text += "      " + trace.decided[k] + "\n";
  }
  return text;
}

std::string text_of_why(PanelContext& context) {
  const std::string text = explanation_of(context);
  return text.empty() ? "" : text + "\n";
}

using TableOfPanel = TextTable (*)(PanelContext&);
const std::map<std::string_view, TableOfPanel>& tables_of_panels() {
  static const std::map<std::string_view, TableOfPanel> kTables{
      {"tree", table_of_tree},          {"icicle", table_of_tree},
      {"events", table_of_events},      {"breakpoints and bookmarks", table_of_stops},
      {"ballot", table_of_ballot},      {"oracle", table_of_oracle},
      {"lint", table_of_findings},      {"compare", table_of_comparison},
      {"lanes", table_of_lanes},        {"table", table_of_rows},
      {"what if", table_of_parameters}, {"scene", table_of_scene}};
  return kTables;
}

/// Null if there is none.
const CopiedPanel* panel_under_mouse(const PanelContext& context) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto is_there = [&](std::string_view place) {
    const auto area = context.gui.find("panel " + std::string(place));
    return area && area->has(mouse.x, mouse.y);
  };
  const auto found = std::ranges::find_if(kCopiedPanels, is_there, &CopiedPanel::place);
  return found == kCopiedPanels.end() ? nullptr : &*found;
}

/// Null if there is none.
const CopiedPanel* panel_called(std::string_view name) {
  const auto found = std::ranges::find(kCopiedPanels, name, &CopiedPanel::name);
  return found == kCopiedPanels.end() ? nullptr : &*found;
}

/// Of panels that share a cell as tabs the one that is seen.
const CopiedPanel* seen_instead_of(const PanelContext& context, const CopiedPanel* panel) {
  if (panel == nullptr) return nullptr;
  const WindowLayout& layout = context.memory.window.layout;
  for (std::size_t k = 0; k < kPanelCount; ++k) {
    const auto cell = layout.find(static_cast<PanelId>(k));
    if (!cell || panel_name(static_cast<PanelId>(k)) != panel->place) continue;
    const PanelCell& tabs = layout.cells(cell->place)[cell->cell];
    const auto found =
        std::ranges::find(kCopiedPanels, panel_name(tabs.tabs[tabs.shown]), &CopiedPanel::place);
    return found == kCopiedPanels.end() ? nullptr : &*found;
  }
  return panel;
}

void copy(PanelContext& context, const CopiedPanel& panel, bool as_csv) {
  const auto report = [&](const std::string& what) {
    context.model.message = what;
    context.model.message_is_error = false;
  };
  const std::string name(panel.name);
  if (!panel.is_table) {
    const std::string text = name == "why"         ? text_of_why(context)
                             : name == "algorithm" ? text_of_algorithm(context)
                                                   : text_of_moment(context);
    if (text.empty()) return report(name + " has nothing to copy");
    return put_into_clipboard(context, text, name + (as_csv ? " as text: it is no table" : ""));
  }
  const TextTable table = tables_of_panels().at(panel.name)(context);
  if (table.rows.empty()) return report(name + " has nothing to copy");
  put_into_clipboard(context, as_csv ? to_csv(table) : to_text(table),
                     name + ", " + counted(table.rows.size(), "row") + (as_csv ? " as CSV" : ""));
}

}  // namespace

void put_into_clipboard(PanelContext& context, std::string text, const std::string& what) {
  context.memory.copied = std::move(text);
  context.memory.to_clipboard = context.memory.copied;
  context.model.message = "copied " + what;
  context.model.message_is_error = false;
}

void copy_as_wished(PanelContext& context) {
  SessionMemory& session = context.memory.session;
  const CopiedPanel* const under = panel_under_mouse(context);
  if (under != nullptr && ImGui::IsMouseClicked(0)) session.used_panel = under->name;
  const auto wish = std::exchange(session.copy, std::nullopt);
  if (!wish) return;
  const CopiedPanel* panel = panel_called(wish->panel);
  if (panel == nullptr)
    panel = seen_instead_of(context, under != nullptr ? under : panel_called(session.used_panel));
  if (panel != nullptr) return copy(context, *panel, wish->as_csv);
  context.model.message = "put the mouse over a panel to copy it";
  context.model.message_is_error = false;
}

}  // namespace kerf

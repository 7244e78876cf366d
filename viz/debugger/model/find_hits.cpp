#include "viz/debugger/model/find_hits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "core/query/asked_query.h"
#include "core/query/text.h"

namespace kerf {
namespace {

struct DebuggerCommand {
  const char* name;
  const char* key;
  void (*go)(DebuggerModel& model);
};

constexpr auto kCommands = std::to_array<DebuggerCommand>({
    {"play or pause", "Space", [](DebuggerModel& model) { model.playing = !model.playing; }},
    {"next operator", ".", [](DebuggerModel& model) { model.step(Granularity::op, true); }},
    {"previous operator", ",", [](DebuggerModel& model) { model.step(Granularity::op, false); }},
    {"next step", "Shift+.", [](DebuggerModel& model) { model.step(Granularity::step, true); }},
    {"previous step", "Shift+,", [](DebuggerModel& model) { model.step(Granularity::step, false); }},
    {"start of the run", "Home", [](DebuggerModel& model) { model.step(Granularity::run, false); }},
    {"end of the run", "End", [](DebuggerModel& model) { model.step(Granularity::run, true); }},
    {"first step with a grown tree", "", [](DebuggerModel& model) { model.go_to_opening(); }},
    {"run to a breakpoint", "F5", [](DebuggerModel& model) { model.run_to_breakpoint(true); }},
    {"run back to a breakpoint", "Shift+F5", [](DebuggerModel& model) { model.run_to_breakpoint(false); }},
    {"breakpoint at this moment", "F9", [](DebuggerModel& model) { model.toggle_breakpoint_here(); }},
    {"bookmark this moment", "B", [](DebuggerModel& model) { model.toggle_bookmark(); }},
    {"ask the oracle", "O", [](DebuggerModel& model) { static_cast<void>(model.ask_oracle()); }},
    {"hide or show the selection", "H", [](DebuggerModel& model) { model.toggle_hidden(); }},
    {"only below the selected node", "I", [](DebuggerModel& model) { model.toggle_isolated(); }},
    {"show all", "", [](DebuggerModel& model) { model.show_all(); }},
    {"deselect", "Esc", [](DebuggerModel& model) { model.deselect(); }},
    {"maximum of the lane", "M", [](DebuggerModel& model) { model.go_to_extreme(true); }},
    {"minimum of the lane", "Shift+M", [](DebuggerModel& model) { model.go_to_extreme(false); }},
    {"loop the range", "L", [](DebuggerModel& model) { model.toggle_loop(); }},
});

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// The next value of an enumeration.
template <class Enumeration>
Enumeration following(Enumeration value) {
  return static_cast<Enumeration>(static_cast<int>(value) + 1);
}

SearchHit selecting(const Selection& thing, const GivenNames& names, std::string note) {
  return {to_string(thing, names), std::move(note), [thing](DebuggerModel& model) { model.select(thing); }};
}

void add_node(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  const auto id = parse_given_id(query.starts_with('n') ? query.substr(1) : query);
  if (!id || id->negative || id->magnitude > UINT32_MAX) return;
  const NodeId node{static_cast<std::uint32_t>(id->magnitude)};
  if (model.run().tree().is_alive(node)) hits.push_back(selecting(node, model.run().names(), "node"));
}

void add_object(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  const GivenNames& names = model.run().names();
  const auto given = parse_given_id(query);
  const auto object = given ? names.find_object(*given) : std::nullopt;
  if (object && model.run().has(*object)) hits.push_back(selecting(*object, names, "object"));
}

/// Objects by their labels.
void add_labelled(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  constexpr std::size_t kMost = 30;
  for (const ObjectId object : model.run().info().marks.called(query)) {
    if (!model.run().has(object)) continue;
    if (hits.size() == kMost) return;
    hits.push_back({model.run().title(object), "object", [object](DebuggerModel& to) { to.select(object); }});
  }
}

void add_step(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  const GivenNames& names = model.run().names();
  const auto step = names.find_step(query);
  if (!step || *step > model.run().steps()) return;
  hits.push_back({"step " + names.step(*step), "its end",
                  [at = *step](DebuggerModel& to) { to.go(Position::end_of(at)); }});
}

void add_pair(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  const std::size_t comma = query.find(',');
  if (comma == std::string_view::npos) return;
  const GivenNames& names = model.run().names();
  const auto object = [&](std::string_view text) {
    const auto given = parse_given_id(text);
    return given ? names.find_object(*given) : std::nullopt;
  };
  const auto a = object(query.substr(0, comma));
  const auto b = object(query.substr(comma + 1));
  if (!a || !b || *a == *b || !model.run().has(*a) || !model.run().has(*b)) return;
  const Pair pair = make_pair(*a, *b);
  const bool is_pair = std::ranges::find(model.run().pairs(), pair) != model.run().pairs().end();
  hits.push_back(
      selecting(pair, names, is_pair ? "pair" + model.run().note_on_pairs() : "two objects, no pair now"));
}

void add_event(DebuggerModel& model, std::string_view query, std::vector<SearchHit>& hits) {
  if (!query.starts_with('e')) return;
  const auto id = parse_given_id(query.substr(1));
  if (!id || id->negative || !model.run().step_of(id->magnitude)) return;
  hits.push_back({"e" + std::to_string(id->magnitude), "event",
                  [event = id->magnitude](DebuggerModel& to) { to.go_to_event(event); }});
}

void add_commands(const std::string& query, std::vector<SearchHit>& hits) {
  const auto add = [&](const std::string& name, const std::string& key,
                       std::function<void(DebuggerModel&)> go) {
    if (has_all_words(name, query)) hits.push_back({name, key, std::move(go)});
  };
  for (const DebuggerCommand& command : kCommands) add(command.name, command.key, command.go);
  auto kind = EventKind{};
  for (const std::string_view name : kEventKindNames) {
    for (const bool forwards : {true, false})
      add((forwards ? "next " : "previous ") + std::string(name), "go there",
          [kind, forwards](DebuggerModel& model) { model.go_to_kind(kind, forwards); });
    kind = following(kind);
  }
  auto tint = Tint{};
  for (const std::string_view name : kTintNames) {
    add("colour by " + std::string(name), "scene and icicle",
        [tint](DebuggerModel& model) { model.view.tint = tint; });
    tint = following(tint);
  }
  for (const std::string_view direction : kDirectionNames)
    add("view from " + std::string(direction), "V",
        [direction](DebuggerModel& model) { model.view.face(direction); });
  for (const Layer layer :
       {Layer::objects, Layer::partitioners, Layer::leaves, Layer::pairs, Layer::operators})
    add("show or hide " + std::string(to_string(layer)), "layer of the scene",
        [layer](DebuggerModel& model) { model.view.layers.set(layer, !model.view.layers.has(layer)); });
}

/// 0 for the name itself, 1 for its begin, 2 for whole words of it.
int distance_to(const std::string& name, const std::string& query) {
  if (name.starts_with(query)) return name == query ? 0 : 1;
  return (" " + name + " ").find(" " + query + " ") != std::string::npos ? 2 : 3;
}

/// A name alone, such as pairs, is no condition yet.
void add_condition(const std::string& query, std::vector<SearchHit>& hits) {
  if (query.find_first_of("<>=!()") == std::string::npos) return;
  try {
    static_cast<void>(Expression::parse(query));
  } catch (const std::invalid_argument&) {
    return;
  }
  for (const bool forwards : {true, false})
    hits.push_back({(forwards ? "next moment where " : "previous moment where ") + query, "go there",
                    [query, forwards](DebuggerModel& model) { model.go_to_condition(query, forwards); }});
  hits.push_back(
      {"stop where " + query, "breakpoint", [query](DebuggerModel& model) { model.add_breakpoint(query); }});
}

/// What begins as a query; whatever is not finished says its form when it is chosen.
void add_query(const std::string& query, std::vector<SearchHit>& hits) {
  for (const std::string_view kind : kQueryKindNames)
    if (query.starts_with(std::string(kind) + " "))
      hits.push_back(
          {query, "ask the tree; drawn and explained", [query](DebuggerModel& to) { to.ask(query); }});
}

void add_bookmarks(const DebuggerModel& model, const std::string& query, std::vector<SearchHit>& hits) {
  for (const auto& [moment, note] : model.bookmarks) {
    const std::string name = "bookmark " + to_string(moment, model.run().names());
    if (has_all_words(name + " " + note, query))
      hits.push_back(
          {name, note.empty() ? "go there" : note, [at = moment](DebuggerModel& to) { to.go(at); }});
  }
}

}  // namespace

bool has_all_words(const std::string& name, const std::string& query) {
  std::istringstream words(lower(query));
  const std::string in = lower(name);
  return std::all_of(std::istream_iterator<std::string>(words), {},
                     [&](const std::string& word) { return in.find(word) != std::string::npos; });
}

std::vector<SearchHit> find_hits(DebuggerModel& model, std::string_view query) {
  std::vector<SearchHit> hits;
  std::string text(query);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  std::string_view id = text;
  for (const std::string_view word : {"node ", "object ", "pair ", "event ", "step "})
    if (id.starts_with(word)) id.remove_prefix(word.size());
  if (!id.empty()) {
    const std::string_view kind = std::string_view(text).substr(0, text.size() - id.size());
    const auto may_be = [&](std::string_view word) { return kind.empty() || kind == word; };
    if (may_be("node ")) add_node(model, id, hits);
    if (may_be("pair ")) add_pair(model, id, hits);
    if (may_be("event ")) add_event(model, id, hits);
    if (may_be("object ")) add_object(model, id, hits);
    if (may_be("step ")) add_step(model, id, hits);
    if (may_be("object ")) add_labelled(model, id, hits);
  }
  add_query(text, hits);
  add_condition(text, hits);
  add_bookmarks(model, text, hits);
  std::vector<SearchHit> commands;
  add_commands(lower(text), commands);
  std::ranges::stable_sort(commands, {},
                           [&](const SearchHit& hit) { return distance_to(hit.text, lower(text)); });
  std::ranges::move(commands, std::back_inserter(hits));
  return hits;
}

}  // namespace kerf

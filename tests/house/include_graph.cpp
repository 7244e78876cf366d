#include "tests/house/include_graph.h"

#include <algorithm>

#include "tests/house/include_rules.h"

namespace kerf::house {
namespace {

std::string room_of(std::string_view file) { return std::string(file.substr(0, file.find('/') + 1)); }

std::string place_of(std::string_view file) {
  const Layer* const layer = layer_of(file);
  return layer != nullptr ? std::string(layer->folder) : room_of(file);
}

void add_include(const std::string& file, const Include& include, IncludeGraph& graph) {
  const auto owner = owner_of(include.header);
  if (!owner) return;
  const std::string place = place_of(file);
  const std::string room = room_of(file);
  if (std::ranges::find(rooms(), *owner) == rooms().end())
    graph.libraries[place].emplace(*owner);
  else if (room_of(include.header) != room)
    graph.rooms[room].insert(room_of(include.header));
  else if (place_of(include.header) != place)
    graph.places[place].insert(place_of(include.header));
}

bool reaches(const Edges& edges, const std::string& from, const std::string& to) {
  const auto out = edges.find(from);
  if (out == edges.end()) return false;
  return std::ranges::any_of(out->second,
                             [&](const std::string& next) { return next == to || reaches(edges, next, to); });
}

/// Whether another place that `targets` names leads to `target`, too.
bool is_implied(const Edges& edges, const std::set<std::string>& targets, const std::string& target) {
  return std::ranges::any_of(
      targets, [&](const std::string& other) { return other != target && reaches(edges, other, target); });
}

}  // namespace

IncludeGraph read_include_graph(const std::filesystem::path& root,
                                std::span<const std::filesystem::path> files) {
  IncludeGraph graph;
  for (const std::filesystem::path& file : files)
    for (const Include& include : includes_of(root / file))
      add_include(file.generic_string(), include, graph);
  return graph;
}

Edges reduced(const Edges& edges) {
  Edges kept;
  for (const auto& [from, targets] : edges)
    for (const std::string& target : targets)
      if (!is_implied(edges, targets, target)) kept[from].insert(target);
  return kept;
}

}  // namespace kerf::house

#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>

namespace kerf::house {

/// What each place includes. A place is a layer ("core/tree/") or a room without layers ("sims2d/").
using Edges = std::map<std::string, std::set<std::string>>;

struct IncludeGraph {
  Edges places;     ///< other places of the same room
  Edges rooms;      ///< other rooms, by room
  Edges libraries;  ///< libraries outside of the house, by place
};

/// Reads the #include lines of the given C++ files (paths relative to `root`).
IncludeGraph read_include_graph(const std::filesystem::path& root,
                                std::span<const std::filesystem::path> files);

/// The edges of a graph without cycles that no longer path implies (its transitive reduction).
Edges reduced(const Edges& edges);

}  // namespace kerf::house

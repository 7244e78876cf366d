#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/given_names.h"
#include "frames/import/box_lines.h"
#include "frames/import/given_nodes.h"
#include "frames/import/given_pairs.h"
#include "frames/import/oddities.h"

namespace kerf {

/// What is known of an import before it is played.
struct Survey {
  std::vector<GivenStep> steps;         ///< of boxes and pairs together, in order
  GivenNames names;                     ///< of the recording: none where the engine counts as we do
  std::vector<GivenId> objects;         ///< those that have a line, rising
  std::optional<TheirDigits> digits{};  ///< of boxes and nodes, if there are both
  BoundRounding rounding{};             ///< of the boxes' bounds
  BoundRounding suspected{};            ///< of bounds that are too few to be sure
  double suspected_from = 0;            ///< smaller ones are sure

  [[nodiscard]] ObjectId object(const GivenId& id) const { return *names.find_object(id); }
  /// Whether what a node holds is one: -1 is none, unless it has a line.
  [[nodiscard]] bool is_object(const GivenId& id) const {
    return id != kNoIndex || std::ranges::binary_search(objects, id);
  }
  /// None: no box has this object.
  [[nodiscard]] std::optional<ObjectId> find(const GivenId& id) const {
    return std::ranges::binary_search(objects, id) ? names.find_object(id) : std::nullopt;
  }
};

/// Reads the boxes once and names everything: objects get small numbers, so that what a run costs depends on
/// how many there are. Where their own numbers are small, these stay. Notes what is odd about the steps.
/// Throws UsageError that names the line if steps do not rise, if a pair's step comes before the first one,
/// if steps of pairs are not written as those of boxes are (`check_alike`), or if nodes are of a step that
/// has neither boxes nor pairs.
Survey survey(BoxLines& boxes, const std::vector<GivenPairs>& pairs, const std::string& pairs_name,
              const GivenTrees& trees, const std::string& nodes_name, Oddities& oddities);

}  // namespace kerf

#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "frames/import/box_lines.h"

namespace kerf {

/// A node of another engine's tree of boxes.
struct GivenNode {
  GivenId node;
  std::optional<GivenId> parent;
  std::array<double, 3> min{};
  std::array<double, 3> max{};
  std::vector<GivenId> objects;
  std::optional<bool> leaf;
  double margin = 0;
  std::size_t line = 0;
};

/// Those of one step, in the order of the lines.
struct GivenNodes {
  GivenStep step;
  std::vector<GivenNode> nodes;
};

/// Reads step,node,parent,min_x,max_x,min_y,max_y[,min_z,max_z],object[,leaf][,margin] by the names of a
/// heading, in any order; the result is in the order of the steps. Throws as CsvTable does.
std::vector<GivenNodes> read_given_nodes(const std::filesystem::path& path, int dimension);

}  // namespace kerf

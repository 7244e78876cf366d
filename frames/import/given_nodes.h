#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "frames/import/box_lines.h"
#include "frames/import/oddities.h"

namespace kerf {

/// How engines say that there is no parent or no object.
inline constexpr GivenId kNoIndex{true, 1};

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

/// Those of one step, in the order of the lines; none: the tree is empty.
struct GivenNodes {
  GivenStep step;
  std::size_t line = 0;  ///< the first
  std::vector<GivenNode> nodes;
};

/// What a table of nodes says.
struct GivenTrees {
  std::vector<GivenNodes> steps;  ///< in their order
  TableWriting digits;            ///< of all bounds
};

/// Reads step,node,parent,min_x,max_x,min_y,max_y[,min_z,max_z],object[,leaf][,margin] by the names of a
/// heading, in any order; a line with nothing but a step is that of an empty tree. Throws as CsvTable does.
GivenTrees read_given_nodes(const std::filesystem::path& path, int dimension, Oddities& oddities);

}  // namespace kerf

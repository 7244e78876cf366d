#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "viz/draw/color.h"

namespace kerf {

/// A corner in clip coordinates. The CPU computes these, in one fixed order of operations, so that the driver
/// does not influence positions.
struct Vertex {
  float x, y, z, w;
  Color color;  ///< of the whole triangle: the last corner's counts
};

/// Triangles drawn by one call.
struct Batch {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> items;  ///< by vertex, if kept: its item of the draw list
  std::uint32_t item = 0;            ///< the item of the vertices added from now on
  bool keeps_items = false;

  void clear() {
    vertices.clear();
    indices.clear();
    items.clear();
    item = 0;
  }
  [[nodiscard]] bool empty() const { return indices.empty(); }

  std::uint32_t add_vertex(const Eigen::Vector4d& clip, Color color) {
    vertices.push_back({static_cast<float>(clip.x()), static_cast<float>(clip.y()),
                        static_cast<float>(clip.z()), static_cast<float>(clip.w()), color});
    if (keeps_items) items.push_back(item);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices.insert(indices.end(), {a, b, c});
  }
  /// A convex polygon, already in clip coordinates.
  void add_fan(std::span<const Eigen::Vector4d> corners, Color color) {
    if (corners.size() < 3) return;
    const std::uint32_t first = add_vertex(corners[0], color);
    for (std::size_t i = 1; i < corners.size(); ++i) add_vertex(corners[i], color);
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) add_triangle(first, first + i, first + i + 1);
  }
};

}  // namespace kerf

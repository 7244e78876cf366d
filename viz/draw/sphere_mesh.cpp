#include "viz/draw/sphere_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace kerf {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Index of the point half way between two vertices, pushed out to the sphere.
std::uint32_t middle(std::vector<Eigen::Vector3d>& vertices, std::map<Triangle, std::uint32_t>& known,
                     std::uint32_t a, std::uint32_t b) {
  const Triangle edge{std::min(a, b), std::max(a, b), 0};
  const auto [found, is_new] = known.try_emplace(edge, static_cast<std::uint32_t>(vertices.size()));
  if (is_new) {
    const Eigen::Vector3d sum = vertices[a] + vertices[b];
    vertices.push_back(sum.normalized());
  }
  return found->second;
}

std::vector<Triangle> divide(std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles) {
  std::map<Triangle, std::uint32_t> known;
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : triangles) {
    const std::uint32_t ab = middle(vertices, known, a, b);
    const std::uint32_t bc = middle(vertices, known, b, c);
    const std::uint32_t ca = middle(vertices, known, c, a);
    result.insert(result.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return result;
}

SphereMesh make_mesh(int level) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  SphereMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.normalize();
  std::vector<Triangle> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < level; ++i) triangles = divide(mesh.vertices, triangles);
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const Eigen::Vector3d normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    mesh.faces.push_back({t, normal, normal.dot(a)});
  }
  return mesh;
}

}  // namespace

const SphereMesh& sphere_mesh_for(double radius_in_pixels) {
  static const std::array<SphereMesh, 4> kMeshes{make_mesh(0), make_mesh(1), make_mesh(2), make_mesh(3)};
  const std::size_t level = radius_in_pixels < 5    ? 0
                            : radius_in_pixels < 24 ? 1
                            : radius_in_pixels < 90 ? 2
                                                    : 3;
  return kMeshes[level];
}

}  // namespace kerf

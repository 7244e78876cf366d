#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace kerf {

/// A faceted unit sphere: an icosahedron, each face divided into four `level` times.
struct SphereMesh {
  struct Face {
    std::array<std::uint32_t, 3> corners;
    Eigen::Vector3d normal;  ///< unit, outwards
    double height = 0;       ///< distance of the face's plane from the centre
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
};

/// The coarsest mesh without visible facets for a ball of so many pixels.
const SphereMesh& sphere_mesh_for(double radius_in_pixels);

}  // namespace kerf

#include "sims3d/geoms.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "core/scene/bounding.h"
#include "sims3d/ode/geom_box.h"

namespace kerf {
namespace {

static_assert(sizeof(dTriIndex) == sizeof(std::uint32_t));
static_assert(sizeof(Vector<3>) == 3 * sizeof(float));

bool is_size(Scalar x) { return std::isfinite(x) && x > 0; }

Geom make(const Ball& ball) {
  if (!is_size(ball.radius)) throw std::invalid_argument("a ball's radius must be positive and finite");
  return {nullptr, OdeHandle<dxGeom>(dCreateSphere(nullptr, static_cast<double>(ball.radius)))};
}

Geom make(const Brick<3>& brick) {
  std::array<double, 3> size{};
  for (int i = 0; i < 3; ++i) {
    if (!is_size(brick.half[i]))
      throw std::invalid_argument("a brick's half extents must be positive and finite");
    size[static_cast<std::size_t>(i)] = 2 * static_cast<double>(brick.half[i]);
  }
  return {nullptr, OdeHandle<dxGeom>(dCreateBox(nullptr, size[0], size[1], size[2]))};
}

void check(const Surface& surface) {
  if (surface.triangles.empty()) throw std::invalid_argument("a surface needs a triangle");
  for (const Vector<3>& vertex : surface.vertices)
    if (!is_finite(vertex)) throw std::invalid_argument("a surface's vertices must be finite");
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= surface.vertices.size())
        throw std::invalid_argument("a surface's triangle names a vertex that it does not have");
}

Geom make(const std::shared_ptr<const Surface>& surface) {
  if (!surface) throw std::invalid_argument("a surface is missing");
  check(*surface);
  Geom made;
  made.mesh.reset(dGeomTriMeshDataCreate());
  dGeomTriMeshDataBuildSingle(made.mesh.get(), surface->vertices.data(), sizeof(Vector<3>),
                              static_cast<int>(surface->vertices.size()), surface->triangles.data(),
                              static_cast<int>(3 * surface->triangles.size()), 3 * sizeof(dTriIndex));
  made.geom.reset(dCreateTriMesh(nullptr, made.mesh.get(), nullptr, nullptr, nullptr));
  return made;
}

dMass mass_of(const Ball& ball, double density) {
  dMass mass;
  dMassSetSphere(&mass, density, static_cast<double>(ball.radius));
  return mass;
}

dMass mass_of(const Brick<3>& brick, double density) {
  dMass mass;
  dMassSetBox(&mass, density, 2 * static_cast<double>(brick.half[0]), 2 * static_cast<double>(brick.half[1]),
              2 * static_cast<double>(brick.half[2]));
  return mass;
}

dMass mass_of(const std::shared_ptr<const Surface>&, double) {
  throw std::invalid_argument("a surface cannot move: it has no inside and so no mass");
}

}  // namespace

Geom make_geom(const Shape<3>& shape) {
  return std::visit([](const auto& known) { return make(known); }, shape);
}

dMass make_mass(const Shape<3>& shape, double density) {
  return std::visit([density](const auto& known) { return mass_of(known, density); }, shape);
}

Volume<3> outward_volume(VolumeKind kind, const Shape<3>& shape, dGeomID geom) {
  if (kind == VolumeKind::box) return make_box_volume(outward_box(geom));
  const dReal* position = dGeomGetPosition(geom);
  const dReal* rotation = dGeomGetRotation(geom);
  PrecisePose<3> pose;
  for (std::size_t i = 0; i < 3; ++i) {
    pose.position[i] = position[i];
    for (std::size_t j = 0; j < 3; ++j) pose.axes[i][j] = rotation[4 * j + i];
  }
  return bound(kind, shape, pose);
}

Pose<3> pose_of(dGeomID geom) {
  const dReal* position = dGeomGetPosition(geom);
  const dReal* rotation = dGeomGetRotation(geom);  // rows of four; the body's axes are its columns
  Pose<3> pose;
  for (int i = 0; i < 3; ++i) {
    pose.position[i] = static_cast<Scalar>(position[i]);
    for (int j = 0; j < 3; ++j)
      pose.axes[static_cast<std::size_t>(i)][j] = static_cast<Scalar>(rotation[4 * j + i]);
  }
  return pose;
}

}  // namespace kerf

#include <algorithm>
#include <array>

#include "frames/report/contact_probe.h"
#include "sims3d/narrow_phase.h"

namespace kerf {

ContactProbe3::~ContactProbe3() {
  const auto lock = library_.enter();
  geoms_.clear();
}

void ContactProbe3::add(const Shape<3>& shape) {
  const auto lock = library_.enter();
  shapes_.push_back(shape);
  geoms_.push_back(make_geom(shapes_.back()));
}

void ContactProbe3::place(ObjectId object, const Pose<3>& pose) {
  const auto lock = library_.enter();
  dMatrix3 rotation{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      rotation[4 * j + i] = static_cast<double>(pose.axes[static_cast<std::size_t>(i)][j]);
  dGeomID geom = geoms_[object.index()].geom.get();
  dGeomSetRotation(geom, rotation);
  dGeomSetPosition(geom, static_cast<double>(pose.position[0]), static_cast<double>(pose.position[1]),
                   static_cast<double>(pose.position[2]));
}

Volume<3> ContactProbe3::volume(VolumeKind kind, ObjectId object) const {
  const auto lock = library_.enter();
  return outward_volume(kind, shapes_[object.index()], geoms_[object.index()].geom.get());
}

std::optional<double> ContactProbe3::depth(Pair pair) const {
  const auto lock = library_.enter();
  std::array<dContactGeom, NarrowPhase::kMaxPoints> points{};
  const int count = dCollide(geoms_[pair.a.index()].geom.get(), geoms_[pair.b.index()].geom.get(),
                             NarrowPhase::kMaxPoints, points.data(), sizeof(dContactGeom));
  if (count == 0) return std::nullopt;
  double deepest = 0;
  for (int k = 0; k < count; ++k) deepest = std::max(deepest, points[static_cast<std::size_t>(k)].depth);
  return deepest;
}

}  // namespace kerf

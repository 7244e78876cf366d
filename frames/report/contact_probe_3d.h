#pragma once

#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"
#include "sims3d/geoms.h"
#include "sims3d/ode_library.h"

namespace kerf {

/// A narrow phase of shapes at given poses: ODE's colliders.
class ContactProbe3 {
 public:
  ContactProbe3() = default;
  ContactProbe3(const ContactProbe3&) = delete;
  ContactProbe3& operator=(const ContactProbe3&) = delete;
  ~ContactProbe3();

  /// The next object.
  void add(const Shape<3>& shape);
  void place(ObjectId object, const Pose<3>& pose);
  /// Bounded as in the scenes.
  [[nodiscard]] Volume<3> volume(VolumeKind kind, ObjectId object) const;
  /// The depth of the overlap at the deepest of up to eight points; none if they do not touch.
  [[nodiscard]] std::optional<double> depth(Pair pair) const;

 private:
  OdeLibrary library_;  // first: the geoms end before it does
  std::vector<Shape<3>> shapes_;
  std::vector<Geom> geoms_;
};

}  // namespace kerf

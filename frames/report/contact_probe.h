#pragma once

#include <box2d/b2_math.h>
#include <box2d/b2_shape.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"
#include "sims3d/geoms.h"
#include "sims3d/ode_library.h"

namespace kerf {

/// A narrow phase of shapes at given poses: Box2D's manifolds.
class ContactProbe2 {
 public:
  /// The next object.
  void add(const Shape<2>& shape);
  void place(ObjectId object, const Pose<2>& pose);
  /// Bounded as in the scenes.
  [[nodiscard]] Volume<2> volume(VolumeKind kind, ObjectId object) const;
  /// The depth of the overlap, Box2D's skins included; none if they do not touch.
  [[nodiscard]] std::optional<double> depth(Pair pair) const;

 private:
  struct Object {
    Shape<2> shape;
    std::shared_ptr<const b2Shape> engine;
    b2Transform transform;
  };
  std::vector<Object> objects_;
};

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

template <int D>
using ContactProbe = std::conditional_t<D == 2, ContactProbe2, ContactProbe3>;

}  // namespace kerf

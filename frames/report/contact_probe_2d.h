#pragma once

#include <box2d/b2_math.h>
#include <box2d/b2_shape.h>

#include <memory>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"

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

}  // namespace kerf

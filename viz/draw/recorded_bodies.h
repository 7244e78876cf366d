#pragma once

#include <cstdint>
#include <vector>

#include "core/objects/object_table.h"
#include "core/recording/look.h"
#include "core/recording/object_marks.h"
#include "core/scene/scene.h"

namespace kerf {

/// The objects of a recording, as boxes. An absent object has no finite box and is not drawn, but keeps its
/// place, since bodies are numbered as objects are.
template <int D>
std::vector<Body<D>> recorded_bodies(const ObjectTable<D>& objects);

/// What a recording says of its objects beside their boxes.
template <int D>
struct Outward {
  const Looks<D>& looks;
  const std::vector<Shape<D>>& shapes;
  const ObjectMarks& marks;
};

/// The same, with their shapes and colours where these were recorded. Throws std::runtime_error if a shape is
/// larger than its box: then the recording is damaged.
template <int D>
std::vector<Body<D>> recorded_bodies(const ObjectTable<D>& objects, const Outward<D>& outward);

/// The number of objects that are present and not fixed.
template <int D>
std::uint32_t count_moving(const ObjectTable<D>& objects);

/// A body that no layer draws.
template <int D>
Body<D> absent_body();

}  // namespace kerf

#include "viz/draw/recorded_bodies.h"

#include <limits>
#include <string>
#include <utility>

#include "core/base/damage.h"
#include "core/scene/pose_in_box.h"

namespace kerf {

template <int D>
Body<D> absent_body() {
  Body<D> body;
  body.shape = Brick<D>{};
  for (int axis = 0; axis < D; ++axis)
    body.box.min[axis] = body.box.max[axis] = body.pose.position[axis] =
        std::numeric_limits<Scalar>::quiet_NaN();
  return body;
}

template <int D>
std::vector<Body<D>> recorded_bodies(const ObjectTable<D>& objects) {
  std::vector<Body<D>> bodies;
  bodies.reserve(objects.bound());
  for (std::uint32_t id = 0; id < objects.bound(); ++id) {
    if (!objects.is_placed({id})) {
      bodies.push_back(absent_body<D>());
      continue;
    }
    const Box<D> box = objects.box({id});
    Body<D> body{Brick<D>{box.extent() * 0.5F}, {}, box, Mobility::moving};
    body.pose.position = box.center();
    if (objects.is_fixed({id})) body.mobility = Mobility::fixed;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

template <int D>
std::vector<Body<D>> recorded_bodies(const ObjectTable<D>& objects, const Outward<D>& outward) {
  std::vector<Body<D>> bodies = recorded_bodies(objects);
  for (std::uint32_t id = 0; id < objects.bound(); ++id) {
    bodies[id].color = outward.marks.color({id});
    const Look<D> look = outward.looks.of({id});
    if (look.shape == kNoShape || !objects.is_placed({id})) continue;
    Shape<D> shape = stretched<D>(outward.shapes.at(look.shape), look.stretch);
    const auto pose = pose_in_box<D>(shape, axes_of(look.turn), bodies[id].box);
    if (!pose) fail_damaged("the shape of object " + std::to_string(id) + " does not fit into its box");
    bodies[id].shape = std::move(shape);
    bodies[id].pose = *pose;
  }
  return bodies;
}

template <int D>
std::uint32_t count_moving(const ObjectTable<D>& objects) {
  std::uint32_t count = 0;
  for (std::uint32_t id = 0; id < objects.bound(); ++id)
    count += objects.state({id}) != ObjectState::absent && !objects.is_fixed({id}) ? 1 : 0;
  return count;
}

template std::uint32_t count_moving<2>(const ObjectTable<2>&);
template std::uint32_t count_moving<3>(const ObjectTable<3>&);
template std::vector<Body<2>> recorded_bodies<2>(const ObjectTable<2>&);
template std::vector<Body<3>> recorded_bodies<3>(const ObjectTable<3>&);
template std::vector<Body<2>> recorded_bodies<2>(const ObjectTable<2>&, const Outward<2>&);
template std::vector<Body<3>> recorded_bodies<3>(const ObjectTable<3>&, const Outward<3>&);
template Body<2> absent_body<2>();
template Body<3> absent_body<3>();

}  // namespace kerf

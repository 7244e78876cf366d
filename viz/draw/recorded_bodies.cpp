#include "viz/draw/recorded_bodies.h"

#include <limits>

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
template Body<2> absent_body<2>();
template Body<3> absent_body<3>();

}  // namespace kerf

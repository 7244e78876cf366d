#include "frames/recorded_bodies.h"

namespace kerf {

template <int D>
std::vector<Body<D>> bodies_of(const ObjectTable<D>& objects) {
  Box<D> somewhere;
  std::vector<Body<D>> bodies;
  for (std::uint32_t id = 0; id < objects.bound(); ++id)
    if (objects.is_placed({id})) somewhere = objects.box({id});
  for (std::uint32_t id = 0; id < objects.bound(); ++id) {
    const bool is_there = objects.is_placed({id});
    const Box<D> box = is_there ? objects.box({id}) : Box<D>{somewhere.center(), somewhere.center()};
    Body<D> body{Brick<D>{box.extent() * 0.5F}, {}, box, Mobility::moving};
    body.pose.position = box.center();
    if (is_there && objects.is_fixed({id})) body.mobility = Mobility::fixed;
    bodies.push_back(body);
  }
  return bodies;
}

template std::vector<Body<2>> bodies_of<2>(const ObjectTable<2>&);
template std::vector<Body<3>> bodies_of<3>(const ObjectTable<3>&);

}  // namespace kerf

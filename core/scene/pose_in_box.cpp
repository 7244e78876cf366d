#include "core/scene/pose_in_box.h"

#include <algorithm>
#include <cmath>

#include "core/base/overloaded.h"
#include "core/geometry/precise.h"
#include "core/scene/bounding.h"

namespace kerf {
namespace {

// Of the shape's size: recordings round axes and sizes to 2^-10 each. Of the coordinates: boxes are floats.
constexpr double kLooseShape = 0x1p-8;
constexpr double kLooseBox = 0x1p-20;

/// A box in doubles.
template <int D>
struct Room {
  Precise<D> middle{};
  Precise<D> half{};
};

template <int D>
Room<D> room_of(const Box<D>& box) {
  Room<D> room;
  for (std::size_t i = 0; i < D; ++i) {
    const auto min = static_cast<double>(box.min.value[i]);
    const auto max = static_cast<double>(box.max.value[i]);
    room.middle[i] = (min + max) / 2;
    room.half[i] = (max - min) / 2;
  }
  return room;
}

template <int D>
Room<D> room_of_brick(const Brick<D>& brick, const std::array<Vector<D>, D>& axes) {
  Room<D> room;
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < D; ++i)
      room.half[i] +=
          std::abs(static_cast<double>(axes[k].value[i])) * static_cast<double>(brick.half.value[k]);
  return room;
}

/// The box of the shape, turned, with its origin at zero.
template <int D>
Room<D> room_of(const Shape<D>& shape, const std::array<Vector<D>, D>& axes) {
  const auto of_corners = [&] {
    return room_of(bound<D>(VolumeKind::box, shape, precise(Pose<D>{{}, axes})).box);
  };
  const auto of_ball = [](const Ball& ball) {
    Room<D> room;
    room.half.fill(static_cast<double>(ball.radius));
    return room;
  };
  return std::visit(Overloaded{of_ball, [&](const Brick<D>& brick) { return room_of_brick<D>(brick, axes); },
                               [&](const Outline&) { return of_corners(); },
                               [&](const std::shared_ptr<const Surface>&) { return of_corners(); }},
                    shape);
}

}  // namespace

template <int D>
std::optional<Pose<D>> pose_in_box(const Shape<D>& shape, const std::array<Vector<D>, D>& axes,
                                   const Box<D>& box) {
  if (!is_valid(box)) return std::nullopt;
  const Room<D> place = room_of(box);
  const Room<D> needed = room_of<D>(shape, axes);
  const double size = *std::ranges::max_element(needed.half);
  Pose<D> pose{{}, axes};
  for (std::size_t i = 0; i < D; ++i) {
    const double loose = kLooseShape * size + kLooseBox * (std::abs(place.middle[i]) + place.half[i]);
    if (!(needed.half[i] <= place.half[i] + loose)) return std::nullopt;
    pose.position.value[i] = static_cast<Scalar>(place.middle[i] - needed.middle[i]);
  }
  return pose;
}

template std::optional<Pose<2>> pose_in_box<2>(const Shape<2>&, const std::array<Vector<2>, 2>&,
                                               const Box<2>&);
template std::optional<Pose<3>> pose_in_box<3>(const Shape<3>&, const std::array<Vector<3>, 3>&,
                                               const Box<3>&);

}  // namespace kerf

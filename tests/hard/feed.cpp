#include "tests/hard/feed.h"

#include <cmath>

#include "core/base/random.h"
#include "core/scene/bounding.h"

namespace kerf::test {
namespace {

// Rotations from rational numbers and a square root: the same with every compiler and library.

PrecisePose<2> turned(std::uint32_t object, PrecisePose<2> pose) {
  Random random(object);
  const double t = random.uniform(-1, 1);  // tangent of half the angle
  const double c = (1 - t * t) / (1 + t * t);
  const double s = 2 * t / (1 + t * t);
  pose.axes = {{{c, s}, {-s, c}}};
  return pose;
}

PrecisePose<3> turned(std::uint32_t object, PrecisePose<3> pose) {
  Random random(object);
  std::array<double, 4> q;
  for (double& x : q) x = random.uniform(-1, 1);
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q) x /= size;
  const auto [w, x, y, z] = q;
  pose.axes = {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
  return pose;
}

}  // namespace

template <int D>
Volume<D> posed_volume(VolumeKind kind, const Request<D>& request) {
  PrecisePose<D> pose;
  Brick<D> brick;
  for (int i = 0; i < D; ++i) {
    const double low = static_cast<double>(request.box.min[i]);
    const double high = static_cast<double>(request.box.max[i]);
    pose.position[static_cast<std::size_t>(i)] = (low + high) / 2;
    brick.half[i] = static_cast<Scalar>((high - low) / 2);
  }
  Volume<D> volume = bound<D>(kind, brick, turned(request.object.value, pose), request.margin);
  if (request.margin > 0) volume.box = request.box;
  return volume;
}

template <int D>
Status ask(BroadPhase<D>& broad_phase, const Request<D>& request, Feed feed) {
  using Kind = typename Request<D>::Kind;
  if (request.kind == Kind::remove) return broad_phase.remove(request.object);
  const bool as_box =
      feed == Feed::boxes || broad_phase.volume_kind() == VolumeKind::box || !is_valid(request.box);
  if (request.kind == Kind::insert)
    return as_box ? broad_phase.insert(request.object, request.box, request.mobility)
                  : broad_phase.insert(request.object, posed_volume(broad_phase.volume_kind(), request),
                                       request.mobility);
  return as_box ? broad_phase.move(request.object, request.box)
                : broad_phase.move(request.object, posed_volume(broad_phase.volume_kind(), request));
}

#define KERF_INSTANTIATE(D)                                          \
  template Volume<D> posed_volume<D>(VolumeKind, const Request<D>&); \
  template Status ask<D>(BroadPhase<D>&, const Request<D>&, Feed);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf::test

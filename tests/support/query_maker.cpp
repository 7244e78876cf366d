#include "tests/support/query_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();

}  // namespace

template <int D>
QueryMaker<D>::QueryMaker(const ObjectTable<D>& table, std::uint64_t seed) : random_(seed) {
  for_each_placed(table, [&](ObjectId object) { boxes_.push_back(table.box(object)); });
  if (boxes_.empty()) boxes_.push_back({});
}

template <int D>
Box<D> QueryMaker<D>::any_box() {
  return boxes_[random_.below(static_cast<std::uint32_t>(boxes_.size()))];
}

/// Often as given, or next to it.
template <int D>
Scalar QueryMaker<D>::near(Scalar x) {
  const std::uint32_t how = random_.below(8);
  if (how == 0) return std::nextafter(x, kMax);
  if (how == 1) return std::nextafter(x, -kMax);
  return x;
}

/// Of those that floats can be.
template <int D>
Scalar QueryMaker<D>::number() {
  constexpr std::array<Scalar, 8> kSome{0, -0.0F, 0x1p-149F, -0x1p-149F, 0x1p-126F, kMax, -kMax, 1};
  return kSome[random_.below(kSome.size())];
}

template <int D>
Vector<D> QueryMaker<D>::point() {
  Vector<D> p;
  const Box<D> box = any_box();
  const std::uint32_t strange = random_.below(32);
  for (int i = 0; i < D; ++i) {
    const std::uint32_t where = random_.below(3);
    p[i] = near(where == 0 ? box.min[i] : where == 1 ? box.max[i] : box.center()[i]);
    if (strange == 0) p[i] = number();
  }
  return p;
}

template <int D>
Box<D> QueryMaker<D>::box() {
  const Vector<D> a = point();
  const Vector<D> b = random_.below(3) == 0 ? a : point();
  Box<D> box{a, a};
  box = join(box, {b, b});
  if (random_.below(16) == 0) box.max[0] = kInfinity;
  return box;
}

template <int D>
Scalar QueryMaker<D>::length() {
  const std::uint32_t how = random_.below(4);
  if (how == 0) return kInfinity;
  if (how == 1) return 1;
  return how == 2 ? std::abs(number()) : static_cast<Scalar>(random_.uniform(0, 4));
}

template <int D>
Sphere<D> QueryMaker<D>::sphere() {
  const Vector<D> center = point();
  const std::uint32_t how = random_.below(4);
  if (how == 0) return {center, length()};
  const Vector<D> to = point();
  const Scalar reach = std::abs(to[0] - center[0]);
  return {center, how == 1 ? near(reach) : reach};
}

template <int D>
Vector<D> QueryMaker<D>::direction() {
  const std::uint32_t how = random_.below(4);
  Vector<D> d = how == 0 ? Vector<D>{} : point() - point();
  if (how == 0) d[static_cast<int>(random_.below(D))] = random_.below(2) == 0 ? 1.0F : -1.0F;
  if (how == 1)
    for (int i = 0; i < D; ++i) d[i] = static_cast<Scalar>(static_cast<int>(random_.below(5)) - 2);
  if (random_.below(32) == 0) d[0] = number();
  return d;
}

template <int D>
Ray<D> QueryMaker<D>::ray() {
  const Vector<D> origin = point();
  const Vector<D> along = direction();
  return {origin, along, length()};
}

template <int D>
Segment<D> QueryMaker<D>::segment() {
  const Vector<D> from = point();
  return {from, point()};
}

template <int D>
SweptBox<D> QueryMaker<D>::swept() {
  const Box<D> moved = random_.below(2) == 0 ? any_box() : box();
  const Vector<D> along = direction();
  return {moved, along, length()};
}

template <int D>
Nearest<D> QueryMaker<D>::nearest() {
  constexpr std::array<std::size_t, 7> kCounts{0, 1, 2, 9, 32, 40, 100'000};
  const Vector<D> center = point();
  const std::size_t count = kCounts[random_.below(kCounts.size())];
  return {center, count, random_.below(2) == 0 ? kInfinity : sphere().radius};
}

template <int D>
Frustum<D> QueryMaker<D>::frustum() {
  planes_.clear();
  const std::uint32_t count = random_.below(6);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vector<D> normal = direction();
    planes_.push_back({normal, near(dot(normal, point()))});
  }
  // More than kernels take, the last ones along those that are there, so that each may cut off some more.
  if (count > 0 && random_.below(8) == 0) {
    while (planes_.size() < 20) {
      const Vector<D> normal = planes_[planes_.size() % count].normal;
      planes_.push_back({normal, near(dot(normal, point()))});
    }
  }
  return {planes_};
}

template class QueryMaker<2>;
template class QueryMaker<3>;

}  // namespace kerf::test

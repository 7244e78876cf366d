#include "core/spatial/divide_objects.h"

#include <algorithm>
#include <array>

#include "core/geometry/sort_key.h"

namespace kerf {
namespace {

/// From so many objects on a pass without branches takes less time than the library, which guesses wrongly
/// at every second comparison.
constexpr std::size_t kFew = 32;
/// Objects among which the pivot is chosen.
constexpr std::size_t kSample = 9;

/// All objects have different keys.
template <int D>
std::uint64_t key_of(const CenteredObject<D>& object, int axis) {
  return std::uint64_t{sort_key(object.center[axis])} << 32U | object.object;
}

/// The key of a sample that is about as far from the least as the object number `count`. It is not the least
/// of all, so there are keys on both sides.
template <int D>
std::uint64_t choose_pivot(std::span<const CenteredObject<D>> objects, std::size_t count, int axis) {
  std::array<std::uint64_t, kSample> sample;
  const std::size_t stride = objects.size() / kSample;
  for (std::size_t k = 0; k < kSample; ++k) sample[k] = key_of(objects[k * stride + stride / 2], axis);
  const std::size_t place = std::max(count * kSample / objects.size(), std::size_t{1});
  const auto pivot = sample.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(sample, pivot);
  return *pivot;
}

/// Moves the objects with keys below the pivot to the front; returns how many there are.
template <int D>
std::size_t move_to_front(std::span<CenteredObject<D>> objects, std::uint64_t pivot, int axis) {
  std::size_t below = 0;
  for (CenteredObject<D>& next : objects) {
    const CenteredObject<D> object = next;
    next = objects[below];
    objects[below] = object;
    below += key_of(object, axis) < pivot ? 1 : 0;
  }
  return below;
}

}  // namespace

template <int D>
int longest_axis(std::span<const CenteredObject<D>> objects) {
  Vector<D> extent;
  for (int i = 0; i < D; ++i) {
    Scalar low = objects.front().center[i];
    Scalar high = low;
    for (const CenteredObject<D>& object : objects) {
      low = std::min(low, object.center[i]);
      high = std::max(high, object.center[i]);
    }
    extent[i] = high - low;
  }
  return static_cast<int>(std::ranges::max_element(extent.value) - extent.value.begin());
}

template <int D>
void divide_objects(std::span<CenteredObject<D>> objects, std::size_t count, int axis) {
  for (bool are_many = objects.size() > kFew; are_many;) {
    const std::size_t size = objects.size();
    const std::size_t below = move_to_front(objects, choose_pivot<D>(objects, count, axis), axis);
    if (count < below) {
      objects = objects.first(below);
    } else {
      objects = objects.subspan(below);
      count -= below;
    }
    // What bad pivots leave is left to the library, which has a bound for its time.
    are_many = objects.size() > kFew && objects.size() <= size - size / 8;
  }
  std::ranges::nth_element(objects, objects.begin() + static_cast<std::ptrdiff_t>(count), {},
                           [axis](const CenteredObject<D>& object) { return key_of(object, axis); });
}

template int longest_axis<2>(std::span<const CenteredObject<2>>);
template int longest_axis<3>(std::span<const CenteredObject<3>>);
template void divide_objects<2>(std::span<CenteredObject<2>>, std::size_t, int);
template void divide_objects<3>(std::span<CenteredObject<3>>, std::size_t, int);

}  // namespace kerf

#include "core/kernels/sort_scalars.h"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/base/tuning.h"

namespace kerf {
namespace {

/// Makes floats whole numbers of the same order, and these floats again.
void turn(std::span<Scalar> scalars) {
  for (Scalar& scalar : scalars) {
    std::int32_t bits = 0;
    std::memcpy(&bits, &scalar, sizeof(bits));
    bits ^= (bits >> 31) & INT32_MAX;
    std::memcpy(&scalar, &bits, sizeof(bits));
  }
}

}  // namespace

void sort_scalars(std::span<Scalar> scalars) {
  for (Scalar& scalar : scalars) scalar += 0.0F;
  if (std::ranges::is_sorted(scalars)) return;
  if (scalars.size() <= tuning::kFewToSort) {
    std::ranges::sort(scalars);
    return;
  }
  // Floats of which many are equal and others next to them are left unsorted by vqsort of Highway 1.0.3, each
  // time otherwise; whole numbers are not.
  thread_local const hwy::Sorter sorter;
  turn(scalars);
  sorter(reinterpret_cast<std::int32_t*>(scalars.data()), scalars.size(), hwy::SortAscending());
  turn(scalars);
}

}  // namespace kerf

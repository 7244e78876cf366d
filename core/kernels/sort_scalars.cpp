#include "core/kernels/sort_scalars.h"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>

#include "core/base/tuning.h"

namespace kerf {

void sort_scalars(std::span<Scalar> scalars) {
  for (Scalar& scalar : scalars) scalar += 0.0F;
  if (std::ranges::is_sorted(scalars)) return;
  if (scalars.size() <= tuning::kFewToSort) {
    std::ranges::sort(scalars);
    return;
  }
  thread_local const hwy::Sorter sorter;
  sorter(scalars.data(), scalars.size(), hwy::SortAscending());
}

}  // namespace kerf

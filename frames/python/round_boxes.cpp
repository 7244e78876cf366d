#include "frames/python/round_boxes.h"

namespace kerf::python {

template <int D>
void round_boxes(std::span<const double> given, std::span<Box<D>> boxes) {
  const double* from = given.data();
  for (Box<D>& box : boxes) {
    for (int i = 0; i < D; ++i) box.min[i] = float_at_most(from[i]);
    for (int i = 0; i < D; ++i) box.max[i] = float_at_least(from[D + i]);
    from += 2 * D;
  }
}

template void round_boxes<2>(std::span<const double>, std::span<Box<2>>);
template void round_boxes<3>(std::span<const double>, std::span<Box<3>>);

}  // namespace kerf::python

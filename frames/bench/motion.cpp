#include "frames/bench/motion.h"

#include <cmath>

namespace kerf {

double side_for(std::uint32_t count, int dimension, double size, double pairs) {
  return size * std::pow(count * std::exp2(dimension - 1) / pairs, 1.0 / dimension);
}

template <int D>
Vector<D> Motion<D>::direction() {
  for (;;) {
    const Vector<D> v = vector_within(-1, 1);
    const Scalar square = dot(v, v);
    if (square > 0.01F && square <= 1) return v * (1 / std::sqrt(square));
  }
}

template class Motion<2>;
template class Motion<3>;

}  // namespace kerf

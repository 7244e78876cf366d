#include "core/spatial/exact_sum.h"

namespace kerf {
namespace {

/// The upper and the lower half of a double's bits (Dekker).
Exact split(double x) {
  const double scaled = 134217729.0 * x;  // 2^27 + 1
  const double high = scaled - (scaled - x);
  return {high, x - high};
}

}  // namespace

void ExactSum::add(double x) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const Exact sum = difference(x, -parts_[k]);
    x = sum.value;
    if (sum.rest != 0) parts_[kept++] = sum.rest;
  }
  if (x != 0) parts_[kept++] = x;
  size_ = kept;
}

void ExactSum::add_product(double a, double b) {
  if (a == 0 || b == 0) return;
  const double product = a * b;
  const Exact x = split(a);
  const Exact y = split(b);
  add(x.rest * y.rest - (((product - x.value * y.value) - x.rest * y.value) - x.value * y.rest));
  add(product);
}

void ExactSum::add_product(const Exact& a, const Exact& b) {
  add_product(a.rest, b.rest);
  add_product(a.rest, b.value);
  add_product(a.value, b.rest);
  add_product(a.value, b.value);
}

int ExactSum::sign() const {
  if (size_ == 0) return 0;
  return parts_[size_ - 1] > 0 ? 1 : -1;
}

}  // namespace kerf

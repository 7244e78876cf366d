#include "frames/python/interrupts.h"

#include <pybind11/pybind11.h>

namespace kerf::python {

bool Interrupts::requested() {
  constexpr auto kEvery = std::chrono::milliseconds(50);
  const auto now = std::chrono::steady_clock::now();
  if (raised_ || now < next_) return raised_ != nullptr;
  next_ = now + kEvery;
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) raised_ = std::make_exception_ptr(pybind11::error_already_set());
  return raised_ != nullptr;
}

void Interrupts::rethrow() const {
  if (raised_) std::rethrow_exception(raised_);
}

}  // namespace kerf::python

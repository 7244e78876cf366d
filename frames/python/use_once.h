#pragma once

#include <stdexcept>

namespace kerf::python {

/// While it lives, its object is in use. Python's threads take turns, but while one of them computes without
/// Python's lock, another one could call the same object: that is a RuntimeError, no race.
class UseOnce {
 public:
  explicit UseOnce(bool& in_use) : in_use_(in_use) {
    if (in_use_)
      throw std::runtime_error(
          "this object is in use by another thread, or by the call that asked for these numbers: give each "
          "thread its own, or take turns with a threading.Lock");
    in_use_ = true;
  }
  ~UseOnce() { in_use_ = false; }
  UseOnce(const UseOnce&) = delete;
  UseOnce& operator=(const UseOnce&) = delete;

 private:
  bool& in_use_;
};

}  // namespace kerf::python

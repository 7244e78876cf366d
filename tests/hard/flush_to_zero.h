#pragma once

#include <cstdint>

#if defined(__SSE__)
#include <immintrin.h>
#endif

namespace kerf::test {

/// Makes the processor take denormals for zero, in operands and results, as audio and game code does. It
/// does nothing if so requested, or on a machine that has no such mode.
class FlushToZero {
 public:
  enum class Where : std::uint8_t { everywhere, operands };
  explicit FlushToZero(bool on, Where where = Where::everywhere) : before_(control()) {
    constexpr unsigned kFlushResults = 0x8000;
    constexpr unsigned kFlushOperands = 0x0040;
    if (on) set_control(before_ | kFlushOperands | (where == Where::operands ? 0 : kFlushResults));
  }
  ~FlushToZero() { set_control(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
#if defined(__SSE__)
  static unsigned control() { return _mm_getcsr(); }
  static void set_control(unsigned word) { _mm_setcsr(word); }
#else
  static unsigned control() { return 0; }
  static void set_control(unsigned /*word*/) {}
#endif
  unsigned before_;
};

}  // namespace kerf::test

#pragma once

#include <cfenv>

namespace kerf {

/// While it lives, results are rounded to the nearest float, whatever the caller has chosen; then to what it
/// has chosen. The maps to bytes round a number and its negative alike (ByteScale), which upward and downward
/// do not; exact sums (ExactSum) find what rounding took only from the nearest result.
class NearestRounding {
 public:
  NearestRounding() : before_(is_surely_nearest() ? kNearest : mode()) {
    if (before_ != kNearest) change_to(kNearest);
  }
  ~NearestRounding() {
    if (before_ != kNearest) change_to(before_);
  }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  /// By two sums, which take less time than a look at the control register. False may be wrong.
  static bool is_surely_nearest() {
    double more = 0x1.8p-53;  // three quarters of the last place of 1
    double less = -0x1.8p-53;
    __asm__ volatile("" : "+m"(more), "+m"(less));  // unknown to the compiler, which would round by itself
    return 1 + more == 1 + 0x1p-52 && less - 1 == -1 - 0x1p-52;
  }

#ifdef __SSE__  // its control register; the other unit has a mode of its own, which nothing here uses
  using Mode = unsigned;
  static constexpr Mode kMode = 0x6000;
  static constexpr Mode kNearest = 0;
  static Mode mode() { return __builtin_ia32_stmxcsr() & kMode; }
  static void set(Mode mode) { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~kMode) | mode); }
#else
  using Mode = int;
  static constexpr Mode kNearest = FE_TONEAREST;
  static Mode mode() { return std::fegetround(); }
  static void set(Mode mode) { std::fesetround(mode); }
#endif

  /// The compiler moves no number that stands in memory across it.
  static void change_to(Mode mode) {
    __asm__ volatile("" : : : "memory");
    set(mode);
    __asm__ volatile("" : : : "memory");
  }

  Mode before_;
};

}  // namespace kerf

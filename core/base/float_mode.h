#pragma once

#include <cfenv>

namespace kerf {

/// While it lives, floats are computed as a program begins with, whatever the caller has chosen: results are
/// rounded to the nearest, and denormals (numbers below 2^-126) are kept. Then as the caller chose. What one
/// call of a tree leaves behind, another finds by the same comparisons, though the two may come from threads
/// of which only one takes denormals for zero. The maps to bytes round a number and its negative alike
/// (ByteScale), which upward and downward do not; exact sums (ExactSum) find what rounding took only from the
/// nearest result.
///
/// On processors other than x86-64 and AArch64 denormals are treated as the caller chose.
class DefaultFloats {
 public:
  DefaultFloats() : before_(are_surely_default() ? kDefault : mode()) {
    if (before_ != kDefault) change_to(kDefault);
  }
  ~DefaultFloats() {
    if (before_ != kDefault) change_to(before_);
  }
  DefaultFloats(const DefaultFloats&) = delete;
  DefaultFloats& operator=(const DefaultFloats&) = delete;

 private:
  /// By three sums, which take less time than a look at the control register. False may be wrong. The third
  /// is a denormal, which counts as zero if results or operands are flushed.
  static bool are_surely_default() {
    double more = 0x1.8p-53;  // three quarters of the last place of 1
    double less = -0x1.8p-53;
    float least = 0x1p-126F;
    __asm__ volatile("" : "+m"(more), "+m"(less), "+m"(least));  // unknown to the compiler
    const bool is_nearest = 1 + more == 1 + 0x1p-52 && less - 1 == -1 - 0x1p-52;
    return is_nearest && 0x1.000002p-126F - least != 0;
  }

#if defined(__SSE__)  // its control register; the other unit has a mode of its own, which nothing here uses
  using Mode = unsigned;
  static constexpr Mode kMode = 0xE040;  // results to zero, rounding, operands to zero
  static constexpr Mode kDefault = 0;
  static Mode mode() { return __builtin_ia32_stmxcsr() & kMode; }
  static void set(Mode mode) { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~kMode) | mode); }
#elif defined(__aarch64__)
  using Mode = unsigned;
  static constexpr Mode kMode = 0x1C00000;  // denormals to zero, rounding
  static constexpr Mode kDefault = 0;
  static Mode mode() { return __builtin_aarch64_get_fpcr() & kMode; }
  static void set(Mode mode) { __builtin_aarch64_set_fpcr((__builtin_aarch64_get_fpcr() & ~kMode) | mode); }
#else
  using Mode = int;
  static constexpr Mode kDefault = FE_TONEAREST;
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

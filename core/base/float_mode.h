#pragma once

#include <cfenv>

namespace kerf {

/// How this thread computes with floats, as the processor has it.
#if defined(__SSE__)  // its control register; the other unit has a mode of its own, which nothing here uses
struct FloatMode {
  using Bits = unsigned;
  static constexpr Bits kUsual = 0;
  static constexpr Bits kRounding = 0x6000;
  static constexpr Bits kOperands = 0x0040;  // whether operands that are denormals are taken for zero
  static constexpr Bits kAll = 0xE040;       // both, and whether such results become zero
  static Bits get(Bits which) { return __builtin_ia32_stmxcsr() & which; }
  static void set(Bits which, Bits bits) {
    __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~which) | bits);
  }
};
#elif defined(__aarch64__)
struct FloatMode {
  using Bits = unsigned long;
  static constexpr Bits kUsual = 0;
  static constexpr Bits kRounding = 0xC00000;
  static constexpr Bits kOperands = 0x1000001;  // whether denormals become zero
  static constexpr Bits kAll = 0x1C00001;
  static Bits get(Bits which) {
    Bits bits = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(bits));
    return bits & which;
  }
  static void set(Bits which, Bits bits) {
    bits |= get(~which);
    __asm__ volatile("msr fpcr, %0" : : "r"(bits));
  }
};
#else
struct FloatMode {
  using Bits = int;
  static constexpr Bits kUsual = FE_TONEAREST;
  static constexpr Bits kRounding = 0;  // of which kind it is, is not asked
  static constexpr Bits kOperands = 1;  // not known
  static constexpr Bits kAll = 0;
  static Bits get(Bits which) { return which == kOperands ? kUsual : std::fegetround(); }
  static void set(Bits /*which*/, Bits bits) { std::fesetround(bits); }
};
#endif

/// While it lives, floats are computed as a program begins with in what the bits stand for, whatever the
/// caller has chosen; then as the caller chose.
template <FloatMode::Bits Which>
class UsualFloats {
 public:
  UsualFloats() : before_(are_surely_usual() ? FloatMode::kUsual : FloatMode::get(Which)) {
    if (before_ != FloatMode::kUsual) change_to(FloatMode::kUsual);
  }
  ~UsualFloats() {
    if (before_ != FloatMode::kUsual) change_to(before_);
  }
  UsualFloats(const UsualFloats&) = delete;
  UsualFloats& operator=(const UsualFloats&) = delete;

 private:
  /// By two sums, or a comparison, which take less time than a look at the control register (1 ns, not 6).
  /// False may be wrong. A sum that shows whether results become zero could raise a signal that the caller
  /// asked for.
  static bool are_surely_usual() {
    if (Which == FloatMode::kOperands) {
      float least = 0x1p-149F;
      __asm__ volatile("" : "+m"(least));
      return least > 0;
    }
    if (Which != FloatMode::kRounding) return false;
    double more = 0x1.8p-53;  // three quarters of the last place of 1
    double less = -0x1.8p-53;
    __asm__ volatile("" : "+m"(more), "+m"(less));  // unknown to the compiler, which would round by itself
    return 1 + more == 1 + 0x1p-52 && less - 1 == -1 - 0x1p-52;
  }
  /// The compiler moves no number that stands in memory across it.
  static void change_to(FloatMode::Bits bits) {
    __asm__ volatile("" : : : "memory");
    FloatMode::set(Which, bits);
    __asm__ volatile("" : : : "memory");
  }

  FloatMode::Bits before_;
};

/// Results are rounded to the nearest: exact sums (ExactSum) find what rounding took only from such.
using NearestRounding = UsualFloats<FloatMode::kRounding>;

/// Boxes are compared as they are: enough where nothing is added, as when a box is moved.
using UsualComparisons = UsualFloats<FloatMode::kOperands>;

/// Results are rounded to the nearest, and on x86-64 and AArch64 denormals (numbers below 2^-126) are kept.
/// What one call of a tree leaves behind, another finds by the same comparisons, though the two may come from
/// threads of which only one takes denormals for zero. The maps to bytes round a number and its negative
/// alike (ByteScale), which upward and downward do not.
using DefaultFloats = UsualFloats<FloatMode::kAll>;

}  // namespace kerf

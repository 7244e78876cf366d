#pragma once

#include <cfenv>

namespace kerf {

/// While it lives, results are rounded to the nearest float, whatever the caller has chosen; then to what it
/// has chosen. The maps to bytes round a number and its negative alike (ByteScale), which upward and downward
/// do not.
class NearestRounding {
 public:
  NearestRounding() : before_(mode()) {
    if (before_ != kNearest) set(kNearest);
  }
  ~NearestRounding() {
    if (before_ != kNearest) set(before_);
  }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
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

  Mode before_;
};

}  // namespace kerf

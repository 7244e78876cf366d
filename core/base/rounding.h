#pragma once

#include <cfenv>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

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
#ifdef __SSE__  // asked alone: the other unit's mode may be another one, and nothing here uses it
  using Mode = unsigned;
  static constexpr Mode kNearest = _MM_ROUND_NEAREST;
  static Mode mode() { return _mm_getcsr() & _MM_ROUND_MASK; }
  static void set(Mode mode) { _mm_setcsr((_mm_getcsr() & ~unsigned{_MM_ROUND_MASK}) | mode); }
#else
  using Mode = int;
  static constexpr Mode kNearest = FE_TONEAREST;
  static Mode mode() { return std::fegetround(); }
  static void set(Mode mode) { std::fesetround(mode); }
#endif

  Mode before_;
};

}  // namespace kerf

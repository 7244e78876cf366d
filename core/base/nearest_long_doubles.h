#pragma once

#include <cfenv>

namespace kerf {

/// While it lives, sums of long doubles and printf round to the nearest. On x86-64 they go by the mode of
/// another unit than that of DefaultFloats; std::fesetround sets both.
class NearestLongDoubles {
 public:
  NearestLongDoubles() : changes_(std::fegetround() != FE_TONEAREST) {
    if (!changes_) return;
    std::fegetenv(&before_);
    std::fesetround(FE_TONEAREST);
  }
  ~NearestLongDoubles() {
    if (changes_) std::fesetenv(&before_);
  }
  NearestLongDoubles(const NearestLongDoubles&) = delete;
  NearestLongDoubles& operator=(const NearestLongDoubles&) = delete;

 private:
  bool changes_;
  std::fenv_t before_{};
};

}  // namespace kerf

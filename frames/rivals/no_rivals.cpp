// A program without other libraries' broad phases (KERF_RIVALS is off).

#include "frames/rivals/rival.h"

namespace kerf {

template <>
std::span<const Rival<2>> rivals<2>() {
  return {};
}

template <>
std::span<const Rival<3>> rivals<3>() {
  return {};
}

}  // namespace kerf

// A program without other libraries' broad phases (KERF_RIVALS is off).

#include "frames/rivals/query_rival.h"
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

template <>
std::vector<std::unique_ptr<QueryRival<2>>> query_rivals<2>() {
  return {};
}

template <>
std::vector<std::unique_ptr<QueryRival<3>>> query_rivals<3>() {
  return {};
}

}  // namespace kerf

#include "frames/rivals/rival.h"

#include <algorithm>

namespace kerf {

template <int D>
std::optional<Rival<D>> find_rival(std::string_view name) {
  const std::span<const Rival<D>> all = rivals<D>();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Rival<D>& r) { return r.name == name; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

template std::optional<Rival<2>> find_rival<2>(std::string_view);
template std::optional<Rival<3>> find_rival<3>(std::string_view);

}  // namespace kerf

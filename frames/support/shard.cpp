#include "frames/support/shard.h"

#include <string_view>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto k = parse_number<std::uint32_t>(std::string_view(text).substr(0, slash));
  const auto n = slash == std::string::npos
                     ? std::nullopt
                     : parse_number<std::uint32_t>(std::string_view(text).substr(slash + 1));
  if (!k || !n || *k == 0 || *k > *n)
    throw UsageError("--shard '" + text + "' is not K/N, such as 3/8, with K from 1 to N");
  return {*k - 1, *n};
}

}  // namespace kerf

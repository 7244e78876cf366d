#include "core/base/given_id.h"

#include <charconv>

namespace kerf {
namespace {

constexpr std::uint64_t kMostNegative = std::uint64_t{1} << 63U;

/// Whether nothing but zeros, at least one, follows the point: 17.0 is 17.
bool is_integral_rest(std::string_view rest) {
  return rest.empty() ||
         (rest.size() > 1 && rest.front() == '.' && rest.find_first_not_of('0', 1) == std::string_view::npos);
}

}  // namespace

std::optional<GivenId> parse_given_id(std::string_view text) {
  GivenId id;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    id.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, id.magnitude);
  if (error != std::errc{} || !is_integral_rest({stop, end})) return std::nullopt;
  if (id.negative && id.magnitude > kMostNegative) return std::nullopt;
  if (id.magnitude == 0) id.negative = false;
  return id;
}

std::string to_string(const GivenId& id) { return (id.negative ? "-" : "") + std::to_string(id.magnitude); }

}  // namespace kerf

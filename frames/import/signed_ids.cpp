#include "frames/import/signed_ids.h"

#include <algorithm>
#include <optional>

#include "frames/support/errors.h"

namespace kerf {
namespace {

/// The same bits with a sign, or without; none if those are no other number.
std::optional<GivenId> other_way(const GivenId& id, int bits) {
  const std::uint64_t half = std::uint64_t{1} << static_cast<unsigned>(bits - 1);
  const std::uint64_t rest = 2 * half - id.magnitude;  // of 64 bits: modulo 2^64
  if (id.negative && id.magnitude > 0 && id.magnitude <= half) return GivenId{false, rest};
  const bool fits = bits == 64 || id.magnitude < 2 * half;
  if (!id.negative && id.magnitude >= half && fits) return GivenId{true, rest};
  return std::nullopt;
}

}  // namespace

void check_sign(const GivenId& id, const std::vector<GivenId>& objects, const std::string& table,
                std::size_t line) {
  if (std::ranges::binary_search(objects, id)) return;
  for (const int bits : {64, 32}) {
    const auto other = other_way(id, bits);
    if (!other || !std::ranges::binary_search(objects, *other)) continue;
    throw UsageError(table + ", line " + std::to_string(line) + ": there is no object " + to_string(id) +
                     ", but " + to_string(*other) + " has the same " + std::to_string(bits) +
                     " bits: write objects with a sign in all tables, or in none");
  }
}

}  // namespace kerf

#pragma once

#include <cstdint>
#include <span>

namespace kerf {

/// Sorts different numbers, ascending: what queries find. A few are sorted by counting for each how many are
/// smaller, without a branch that depends on them.
void sort_found(std::span<std::uint32_t> numbers);
/// The same for numbers below 2^63.
void sort_found(std::span<std::uint64_t> numbers);

}  // namespace kerf

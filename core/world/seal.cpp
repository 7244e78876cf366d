#include "core/world/seal.h"

#include <xxhash.h>

namespace kerf {

std::uint64_t seal_of(std::span<const std::uint8_t> bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

}  // namespace kerf

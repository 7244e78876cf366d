#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

namespace kerf {

/// The properties of a machine that its timings depend on: processor, cores, kernel, compiler, and its load
/// now.
nlohmann::ordered_json describe_machine();

/// Bytes of memory of its own (not shared, not of files) that this process has in RAM, from Linux's
/// /proc/self/smaps_rollup; 0 if that cannot be read.
std::uint64_t own_memory();

/// The most of it at any time, as far as Linux knows: the high-water mark of everything less the memory that
/// is now shared or of files, which in a running process does not shrink.
std::uint64_t peak_own_memory();

}  // namespace kerf

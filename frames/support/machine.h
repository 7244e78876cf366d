#pragma once

#include <nlohmann/json.hpp>

namespace kerf {

/// What one must know of a machine to read its timings: processor, cores, kernel, compiler, and its load now.
nlohmann::ordered_json describe_machine();

}  // namespace kerf

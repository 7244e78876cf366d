#pragma once

#include <nlohmann/json.hpp>

namespace kerf {

/// The properties of a machine that its timings depend on: processor, cores, kernel, compiler, and its load
/// now.
nlohmann::ordered_json describe_machine();

}  // namespace kerf

#pragma once

#include <nlohmann/json.hpp>

namespace kerf {

/// What files and pages hold: objects keep the order in which their members were put in.
using Json = nlohmann::ordered_json;

}  // namespace kerf

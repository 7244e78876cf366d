#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

/// What files and pages hold: objects keep the order in which their members were put in.
using Json = nlohmann::ordered_json;

/// As text, indented; -1: in one line. Bytes that are no UTF-8, which the name of a file may have, are
/// replaced: they are no reason to lose a result.
template <class AnyJson>
std::string json_text(const AnyJson& json, int indent = 1) {
  return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

}  // namespace kerf

#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/base/given_names.h"

namespace kerf {

/// What the user looks at: nothing, a node, an object, or two of them. Outline, view and tables share one.
using Selection = std::variant<std::monostate, NodeId, ObjectId, Pair>;

/// "n17", "object 5", "pair 12,77" or "nothing": the same words in every panel and in scripts.
inline std::string to_string(const Selection& selection, const GivenNames& names = {}) {
  if (const auto* node = std::get_if<NodeId>(&selection)) return "n" + std::to_string(node->value);
  if (const auto* object = std::get_if<ObjectId>(&selection)) return "object " + names.object(*object);
  if (const auto* pair = std::get_if<Pair>(&selection)) return "pair " + names.pair(*pair);
  return "nothing";
}

}  // namespace kerf

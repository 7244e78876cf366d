#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/base/ids.h"

namespace kerf {

/// What the user looks at: nothing, a node, an object, or two of them. Outline, view and tables share one.
using Selection = std::variant<std::monostate, NodeId, ObjectId, Pair>;

/// "n17", "object 5", "pair 12,77" or "nothing": the same words in every panel and in scripts.
inline std::string to_string(const Selection& selection) {
  if (const auto* node = std::get_if<NodeId>(&selection)) return "n" + std::to_string(node->value);
  if (const auto* object = std::get_if<ObjectId>(&selection))
    return "object " + std::to_string(object->value);
  if (const auto* pair = std::get_if<Pair>(&selection))
    return "pair " + std::to_string(pair->a.value) + "," + std::to_string(pair->b.value);
  return "nothing";
}

}  // namespace kerf

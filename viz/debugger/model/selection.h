#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/base/given_names.h"
#include "core/base/ids.h"
#include "core/base/overloaded.h"

namespace kerf {

/// The user's selection: nothing, a node, an object, or two of them. Outline, view and tables share it.
using Selection = std::variant<std::monostate, NodeId, ObjectId, Pair>;

/// "n17", "object 5", "pair 12,77" or "nothing": the same words in every panel and in scripts.
inline std::string to_string(const Selection& selection, const GivenNames& names) {
  return std::visit(Overloaded{
                        [](std::monostate) { return std::string("nothing"); },
                        [](NodeId node) { return "n" + std::to_string(node.value); },
                        [&](ObjectId object) { return "object " + names.object(object); },
                        [&](const Pair& pair) { return "pair " + names.pair(pair); },
                    },
                    selection);
}

inline bool is_nothing(const Selection& selection) { return selection == Selection(); }

/// The selected node, if it is one.
inline std::optional<NodeId> node_in(const Selection& selection) {
  using Answer = std::optional<NodeId>;
  return std::visit(Overloaded{[](NodeId node) { return Answer(node); },
                               NothingFor<Answer, std::monostate, ObjectId, Pair>()},
                    selection);
}

/// The selected object, if it is one alone.
inline std::optional<ObjectId> object_in(const Selection& selection) {
  using Answer = std::optional<ObjectId>;
  return std::visit(Overloaded{[](ObjectId object) { return Answer(object); },
                               NothingFor<Answer, std::monostate, NodeId, Pair>()},
                    selection);
}

}  // namespace kerf

#pragma once

#include <string>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// The quality of a partitioner in words: "65 objects (33 | 34), balance 0.97, 2 straddlers (3.1 %)".
std::string quality_text(const Quality& quality);
/// What Algorithm 1 would do with a node, and the figures by which it decides (paper sections 3.2, 5.2 and
/// 6.1).
template <int D>
std::string wish_text(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names);

}  // namespace kerf

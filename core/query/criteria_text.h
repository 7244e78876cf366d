#pragma once

#include <string>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// The quality of a partitioner in words: "65 objects (33 | 34), balance 0.97, 2 straddlers (3.1 %)".
std::string quality_text(const Quality& quality);
/// What Algorithm 1 finds of a node, and the figures by which it decides (paper sections 3.2, 5.2 and 6.1).
template <int D>
std::string criterion_text(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names);
/// The same, and why a node that is to be repaired may stay as it is (section 4.5).
template <int D>
std::string wish_text(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names);

}  // namespace kerf

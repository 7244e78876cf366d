#include "core/broad_phase/describe.h"

#include "core/bsp/bsp.h"
#include "core/tree/tree_structure.h"

namespace kerf {
namespace {

template <class Trace, int D>
bool describe_bsp(const BroadPhase<D>& broad_phase, StructureParts<D>& parts) {
  const auto* const bsp = dynamic_cast<const Bsp<D, Trace>*>(&broad_phase);
  if (bsp == nullptr) return false;
  describe_tree(bsp->tree(), !bsp->config().byte_sweep, parts);
  return true;
}

}  // namespace

template <int D>
StructureParts<D> describe(const BroadPhase<D>& broad_phase) {
  StructureParts<D> parts;
  if (const auto* const seen = dynamic_cast<const SelfDescribing<D>*>(&broad_phase)) {
    seen->describe(parts);
  } else if (!describe_bsp<NoTrace>(broad_phase, parts) && !describe_bsp<EventLog>(broad_phase, parts) &&
             !describe_bsp<Watch>(broad_phase, parts)) {
    parts.unseen = "it does not describe its structure";
  }
  return parts;
}

template StructureParts<2> describe(const BroadPhase<2>&);
template StructureParts<3> describe(const BroadPhase<3>&);

}  // namespace kerf

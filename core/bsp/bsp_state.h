#pragma once

#include <cstdint>
#include <vector>

#include "core/base/config.h"
#include "core/bsp/mode_chooser.h"
#include "core/objects/object_table.h"
#include "core/objects/skin.h"
#include "core/tree/hash.h"
#include "core/tree/scheduler.h"
#include "core/tree/tree.h"

namespace kerf {

/// What decides the future of a Bsp between two steps: a keyframe. Kept pairs are left out, since they are
/// found again.
template <int D>
struct BspState {
  Config config;
  Tree<D> tree;
  Scheduler<D> scheduler;
  ObjectTable<D> latest;    ///< the objects as the caller sees them; the tree's own table may have fat boxes
  std::vector<Skin> skins;  ///< by object
  std::vector<Pair> pairs;  ///< of the last step
  ModeChooser modes{D};
  std::uint64_t placed = 0;
  std::uint64_t next_event = 0;
  std::uint32_t step = 0;

  /// As Bsp::state_hash.
  [[nodiscard]] std::uint64_t hash() const { return scheduler.mix_into(kerf::hash(tree)); }
};

}  // namespace kerf

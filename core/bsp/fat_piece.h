#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/bsp/kept_pairs.h"
#include "core/tree/placement.h"

namespace kerf {

/// An object that gets entries anew, and in how many leaves.
struct Arrival {
  ObjectId object;
  std::uint32_t leaves = 0;
};

/// The changes of the tree by one piece of the objects that left their fat boxes.
struct FatPiece {
  std::vector<EntryChange> entries;  ///< of leaves that keep pairs
  std::vector<NodeId> touched;       ///< leaves in which an object stays
  std::vector<ObjectId> leaving;
  std::vector<NodeId> left;  ///< the nodes on their way to their leaves, once for each object
  std::vector<Arrival> entering;
  std::vector<Reached> places;      ///< of `entering`, one object after another
  std::vector<NodeId> entered;      ///< as `left`
  std::vector<Reached> old_places;  ///< scratch: of one object, before the step
  std::vector<Reached> new_places;  ///< scratch: of one object, after it

  void clear() {
    entries.clear();
    touched.clear();
    leaving.clear();
    left.clear();
    entering.clear();
    places.clear();
    entered.clear();
  }
};

}  // namespace kerf

#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/packed_box.h"
#include "core/objects/object_flags.h"
#include "core/objects/skin.h"

namespace kerf {

/// Restless objects of a leaf. All arrays are indexed by object but the lists of objects.
template <int D>
struct FollowJob {
  const PackedBox<D>* latest = nullptr;
  PackedBox<D>* followed = nullptr;  ///< the boxes that follow them
  Skin* skins = nullptr;
  const ObjectFlags* flags = nullptr;  ///< an object with others than kUnrequested is left to the caller
  PackedBox<D> cell;                   ///< closed: an object inside it reaches no other leaf
  const std::uint32_t* objects = nullptr;
  std::size_t count = 0;
  std::uint32_t* left_over = nullptr;  ///< answer: has room for `count`
};

/// Follows each object that lies wholly in the cell, before and now, and is too fast for any skin, as most
/// restless objects are. The rest is left to the caller. Returns the number of objects left over.
template <int D>
std::size_t follow_objects(const FollowJob<D>& job);

}  // namespace kerf

#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/packed_box.h"
#include "core/objects/skin.h"

namespace kerf {

/// Restless objects of a leaf. All arrays are by object but the lists of objects.
template <int D>
struct FollowJob {
  const PackedBox<D>* latest = nullptr;
  PackedBox<D>* followed = nullptr;  ///< the boxes that follow them
  Skin* skins = nullptr;
  const std::uint8_t* attention = nullptr;
  std::uint8_t awaited = 0;  ///< other `attention`: the object is left to the caller
  PackedBox<D> cell;         ///< closed: what lies in it reaches no other leaf
  const std::uint32_t* objects = nullptr;
  std::size_t count = 0;
  std::uint32_t* left_over = nullptr;  ///< answer: has room for `count`
};

/// Follows each object that lies wholly in the cell, before and now, and is too fast for any skin, as most
/// restless ones are. The rest is left to the caller; gives their number.
template <int D>
std::size_t follow_objects(const FollowJob<D>& job);

}  // namespace kerf

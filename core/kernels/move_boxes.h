#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/ids.h"
#include "core/base/task_pool.h"
#include "core/geometry/packed_box.h"

namespace kerf {

/// The bit of an object's `attention` that says: a request for it was left over, so later ones must be, too.
/// The caller takes it back.
inline constexpr std::uint8_t kWaiting = 0x80;

/// The bit of an object's `attention` that says: its box is taken, and it asks for nothing wherever it goes.
inline constexpr std::uint8_t kSilent = 0x40;

/// A request to move many objects, and what the kernel may touch. All arrays are by object but those of the
/// request and of the answer, which have room for as many as are asked to move.
template <int D>
struct MoveRequest {
  std::span<const ObjectId> objects;
  std::span<const Box<D>> boxes;

  std::span<PackedBox<D>> latest;     ///< takes the new boxes
  std::span<std::uint8_t> attention;  ///< not 0, nor kSilent: the object is left to the caller
  /// Finite boxes. An object that stays inside of its own asks for nothing, but if it filled it so far, it
  /// must fill it still. None: all ask.
  const PackedBox<D>* fat = nullptr;

  ObjectId* changed = nullptr;         ///< answer: objects that ask; their `attention` is 1 now
  PackedBox<D>* before = nullptr;      ///< answer, only with `fat`: where they were
  std::uint32_t* left_over = nullptr;  ///< answer: positions of requests that were left to the caller
};

struct MoveAnswer {
  std::size_t changed = 0;
  std::size_t left_over = 0;
};

/// Writes all boxes that can be taken as they are, of objects that need no attention. The rest (NaN, infinite
/// or inverted boxes; objects unknown, in quarantine or noted already) is left to the caller.
template <int D>
MoveAnswer move_boxes(const MoveRequest<D>& request);
/// The same by several threads, if the objects ascend: only then is it plain that none is asked for twice.
template <int D>
MoveAnswer move_boxes(const MoveRequest<D>& request, TaskPool& pool);

}  // namespace kerf

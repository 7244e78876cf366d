#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/ids.h"
#include "core/base/task_pool.h"
#include "core/geometry/packed_box.h"
#include "core/objects/object_flags.h"

namespace kerf {

/// A request to move many objects, and what the kernel may touch. All arrays are indexed by object but those
/// of the request and of the answer, which have room for as many entries as the request.
template <int D>
struct MoveRequest {
  std::span<const ObjectId> objects;
  std::span<const Box<D>> boxes;

  std::span<PackedBox<D>> latest;  ///< receives the new boxes
  std::span<ObjectFlags> flags;    ///< an object with other flags than kUnrequested is left to the caller
  /// Finite fat boxes. An object that stays inside its fat box is not reported as changed; if it filled the
  /// fat box before, it must fill it still. Null: all objects are reported.
  const PackedBox<D>* fat = nullptr;

  ObjectId* changed = nullptr;         ///< answer: objects to be placed; each has flag::kChanged now
  PackedBox<D>* before = nullptr;      ///< answer, only with `fat`: where they were
  std::uint32_t* left_over = nullptr;  ///< answer: positions of requests that were left to the caller
};

struct MoveAnswer {
  std::size_t changed = 0;
  std::size_t left_over = 0;
};

/// Writes all boxes that can be taken as they are, of objects without pending flags. The rest (NaN, infinite
/// or inverted boxes; objects that are unknown, in quarantine or changed already) is left to the caller.
template <int D>
MoveAnswer move_boxes(const MoveRequest<D>& request);
/// The same by several threads, if the objects ascend: only then no object can be named twice.
template <int D>
MoveAnswer move_boxes(const MoveRequest<D>& request, TaskPool& pool);

}  // namespace kerf

#pragma once

#include <span>
#include <string_view>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/geometry/volume.h"
#include "core/objects/status.h"

namespace kerf {

/// A broad phase takes boxes and reports which of them overlap.
///
/// `pairs()` changes only in `step()`; its pairs agree with the last box given for each object. The caller
/// chooses the ids, which should be small: see kFreeIds. A box changes only by a request.
template <int D>
class BroadPhase {
 public:
  BroadPhase() = default;
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;
  virtual ~BroadPhase() = default;

  /// The name by which programs choose it, for example "kerf" or "brute-force".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// How it bounds objects, and so what callers should pass. Boxes are always accepted; a broad phase for
  /// boxes takes the box of any volume.
  [[nodiscard]] virtual VolumeKind volume_kind() const { return VolumeKind::box; }

  /// `clamped` if a bound is infinite, `quarantined` for NaN and inverted boxes, `duplicate_id` if the object
  /// exists, `sparse_id` if its id is far beyond the number of objects.
  virtual Status insert(ObjectId object, const Box<D>& box, Mobility mobility) = 0;
  virtual Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
    return insert(object, volume.box, mobility);
  }
  /// `clamped`, `quarantined`, or `unknown_id` if there is no such object.
  virtual Status move(ObjectId object, const Box<D>& box) = 0;
  virtual Status move(ObjectId object, const Volume<D>& volume) { return move(object, volume.box); }
  /// `unknown_id` if there is no such object.
  virtual Status remove(ObjectId object) = 0;
  /// Equivalent to move(objects[k], boxes[k]) for each k, without the cost per call. All are done, whatever
  /// their statuses. Returns the first status other than `ok`.
  virtual Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
    Status first = Status::ok;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const Status status = move(objects[k], boxes[k]);
      if (first == Status::ok) first = status;
    }
    return first;
  }

  /// Brings the structure up to date and finds all pairs.
  virtual void step() = 0;
  /// The pairs found by the last `step()`, each once, in an order that the implementation fixes.
  [[nodiscard]] virtual std::span<const Pair> pairs() const = 0;
};

}  // namespace kerf

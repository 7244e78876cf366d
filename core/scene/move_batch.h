#pragma once

#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/volume.h"
#include "core/objects/broad_phase.h"

namespace kerf {

/// The objects that a world moved in a step: given to the broad phase in one call, which is what the broad
/// phase is fast at and what `kerf bench` measures.
template <int D>
class MoveBatch {
 public:
  void add(ObjectId object, const Volume<D>& volume) {
    objects_.push_back(object);
    if (volume.kind == VolumeKind::box) {
      boxes_.push_back(volume.box);
    } else {
      volumes_.push_back(volume);
    }
  }

  /// A request that the broad phase refused.
  struct Refusal {
    ObjectId object;
    Status status = Status::ok;
  };
  /// Moves all objects that were added since the last call, in that order. All volumes are of one kind, the
  /// broad phase's. Returns the first refusal; a clamped box is none.
  std::optional<Refusal> send(BroadPhase<D>& broad_phase);

 private:
  std::optional<Refusal> first_refusal(BroadPhase<D>& broad_phase) const;

  std::vector<ObjectId> objects_;
  std::vector<Box<D>> boxes_;       ///< of `objects_`, if they are bounded by boxes
  std::vector<Volume<D>> volumes_;  ///< of `objects_`, if by another kind
};

}  // namespace kerf

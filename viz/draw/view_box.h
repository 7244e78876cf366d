#pragma once

#include <optional>
#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// The view of a sequence of frames: everything seen so far, without following single objects. It only grows,
/// each time by more than needed, so that the picture stands still most of the time.
template <int D>
class ViewBox {
 public:
  /// Adds a frame's bodies. Moving objects far outside of the fixed ones are ignored: one that fell off the
  /// edge must not shrink the rest to a dot.
  void update(std::span<const Body<D>> bodies);
  /// From now on exactly this box. Throws std::invalid_argument unless it is valid and not empty.
  void fix(const Box<D>& box);
  /// A unit box before anything was seen.
  [[nodiscard]] Box<D> box() const;

 private:
  std::optional<Box<D>> box_;
  bool fixed_ = false;
};

extern template class ViewBox<2>;
extern template class ViewBox<3>;

}  // namespace kerf

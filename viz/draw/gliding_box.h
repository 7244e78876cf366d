#pragma once

#include <optional>

#include "core/geometry/box.h"

namespace kerf {

/// The view of a sequence that is drawn as it comes: it goes over to a larger box in several frames, because
/// a picture that zooms out at once jumps. What a frame must show is in it at once.
template <int D>
class GlidingBox {
 public:
  /// The next frame. `goal` has room to spare, which can come later; `needed` lies in it.
  void go_on(const Box<D>& goal, const std::optional<Box<D>>& needed);
  /// From now on this box, at once.
  void jump(const Box<D>& goal);
  /// None before the first frame.
  [[nodiscard]] const std::optional<Box<D>>& box() const { return box_; }

 private:
  std::optional<Box<D>> box_;
  Box<D> goal_;
  int frames_left_ = 0;  ///< until the box is the goal
};

}  // namespace kerf

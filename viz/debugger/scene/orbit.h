#pragma once

#include "viz/draw/camera.h"

namespace kerf {

/// A camera that the mouse moves.
template <int D>
class Orbit {
 public:
  /// What is framed until the user moves: all of `box`.
  void set_box(const Box<D>& box) { box_ = box; }
  [[nodiscard]] View view(int width, int height) const;

  /// Pixels that the mouse went. 2D does not turn: it moves.
  void turn(double dx, double dy, int width, int height);
  void move(double dx, double dy, int width, int height);
  /// Wheel clicks; what lies under the mouse stays there in 2D.
  void zoom(double clicks, double x, double y, int width, int height);
  /// Looks at a box from not too near.
  void look_at(const Box<D>& box, int width, int height);
  void frame_all() { choice_ = CameraChoice<D>{}; }

 private:
  void settle(int width, int height);

  Box<D> box_;
  CameraChoice<D> choice_;
};

extern template class Orbit<2>;
extern template class Orbit<3>;

}  // namespace kerf

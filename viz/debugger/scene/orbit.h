#pragma once

#include "viz/draw/camera.h"

namespace kerf {

/// A camera that the mouse moves.
template <int D>
class Orbit {
 public:
  /// Frames all of `box` until the user moves the camera.
  void set_box(const Box<D>& box) { box_ = box; }
  /// So many pixels at the top and the bottom are no part of what it frames and aims at.
  void leave_free(double above, double below) {
    above_ = above;
    below_ = below;
  }
  [[nodiscard]] View view(int width, int height) const;

  /// Mouse movement in pixels. The 2D camera does not turn: it moves.
  void turn(double dx, double dy, int width, int height);
  void move(double dx, double dy, int width, int height);
  /// Wheel clicks; in 2D the point under the mouse stays there.
  void zoom(double clicks, double x, double y, int width, int height);
  /// Looks at a box from not too near.
  void look_at(const Box<D>& box, int width, int height);
  /// From a direction of `kDirectionNames`, at what it looks at now; 2D has none.
  void face(std::string_view direction);
  void frame_all() { choice_ = CameraChoice<D>{}; }
  [[nodiscard]] const CameraChoice<D>& choice() const { return choice_; }
  void choose(const CameraChoice<D>& choice) { choice_ = choice; }

 private:
  void settle(int width, int height);
  [[nodiscard]] Viewport framed(int width, int height) const;

  Box<D> box_;
  double above_ = 0;
  double below_ = 0;
  CameraChoice<D> choice_;
};

}  // namespace kerf

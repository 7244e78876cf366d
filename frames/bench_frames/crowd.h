#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "viz/draw/frame_renderer.h"

namespace kerf {

/// Boxes that drift about in a cube, half as many pairs as boxes among them, and their tree.
class Crowd {
 public:
  explicit Crowd(std::uint32_t boxes);

  void advance();
  /// Valid until the next step.
  [[nodiscard]] FrameInput<3> input() const;

 private:
  [[nodiscard]] Box<3> box_of(std::size_t k) const;

  float side_;  ///< of the cube; the boxes' sides are about one
  std::vector<Body<3>> bodies_;
  std::vector<Vector<3>> velocities_;
  Bsp<3, EventLog> tree_;
  std::vector<Event> events_;
};

}  // namespace kerf

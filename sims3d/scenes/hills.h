#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/scene/shape.h"

namespace kerf {

/// A landscape over the square [-half, half]^2 of the XZ plane: smooth bumps and hollows within a rim that
/// rises towards the border like the wall of a bowl.
class Hills {
 public:
  Hills(double half, Random random);

  /// Sums and products only, so that each machine builds the same landscape.
  [[nodiscard]] double height(double x, double z) const;
  /// The square tile of `quads` by `quads` squares of 1 unit whose lowest corner is (x, z), as two triangles
  /// a square, counter-clockwise from above. The surface's frame stands at the tile's middle at height 0. A
  /// tile keeps 1/1024 of its width from its neighbours: where boxes touch, any plane between two rows of
  /// them is straddled by one row, and a tree may never find room for it.
  [[nodiscard]] Surface tile(double x, double z, std::uint32_t quads) const;

 private:
  struct Bump {
    double x, z, radius, amplitude;
  };
  double half_;
  std::vector<Bump> bumps_;
};

}  // namespace kerf

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims3d/world.h"

namespace kerf {

/// How objects come into a scene.
struct Drop {
  std::uint32_t objects = 0;     ///< moving objects at the end of the growth
  std::uint32_t steps = 1;       ///< steps over which they come, evenly
  std::vector<Vector<3>> sites;  ///< where they appear, in the shower's order; 2.5 units apart in X or Z
  std::uint32_t recycle = 0;     ///< steps between two objects that fall anew after the growth; 0: none does
  std::uint32_t nudge = 0;       ///< ulps by which the first object is moved aside
  Box<3> inside;                 ///< an object whose centre leaves it is put back on a site
  WorldSettings physics;
};

/// The user's options with 0 replaced by the scene's own default. Throws std::invalid_argument, naming the
/// limit, for more objects or steps than a scene can take.
SceneOptions resolve(const SceneOptions& options, std::uint32_t default_objects, std::uint32_t default_steps);

/// Makes a scene whose objects are all there from the first step on.
template <class S, std::uint32_t DefaultObjects>
std::unique_ptr<Scene<3>> make_at_once(BroadPhase<3>& broad_phase, const SceneOptions& options) {
  return std::make_unique<S>(broad_phase, resolve(options, DefaultObjects, 1));
}

/// Balls and bricks, about one unit in size, that fall into fixed surroundings; their number grows step by
/// step.
///
/// They appear upright but turning, in a shower that wanders over the sites in their order and gives each the
/// same number of objects, so that a tree must follow the crowd; when all have had their share it begins
/// anew. A site that is not yet clear gets its next object so much higher. Fixed objects come first in the
/// numbering.
class DropScene final : public WorldScene<3, OdeWorld> {
 public:
  /// `build` adds the fixed surroundings to the world; it is called once.
  template <class Build>
  DropScene(BroadPhase<3>& broad_phase, const Needs& needs, std::uint64_t seed, Drop drop, Build build)
      : DropScene(broad_phase, needs, seed, std::move(drop)) {
    build(world());
  }

  /// The number of objects that had to be put back so far: 0 in a closed scene.
  [[nodiscard]] std::uint32_t put_back() const { return put_back_; }

 private:
  DropScene(BroadPhase<3>& broad_phase, const Needs& needs, std::uint64_t seed, Drop drop);
  void act() override;
  [[nodiscard]] std::uint32_t due(std::uint32_t step) const;
  void drop_one();
  void put_back_strays();
  void recycle();
  void drop_anew(ObjectId object);
  Vector<3> next_place();
  void plan_shower();

  Random random_;
  Drop drop_;
  std::vector<std::uint32_t> shower_;  // sites in the order of their drops
  std::size_t next_ = 0;
  std::vector<float> last_height_;        // per site, of the object that appeared there last ...
  std::vector<std::uint32_t> last_step_;  // ... and when
  std::vector<ObjectId> dropped_;
  std::size_t recycled_ = 0;  // so far; objects take turns
  std::uint32_t put_back_ = 0;
};

}  // namespace kerf

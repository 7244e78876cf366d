#include <algorithm>
#include <limits>
#include <vector>

#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/hills.h"
#include "sims3d/scenes/scene_entries.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 600;
constexpr std::uint32_t kDefaultSteps = 400;
constexpr std::uint32_t kMinTiles = 16;  // along one side
constexpr std::uint32_t kTile = 4;       // units, and quads, along one side of a tile
constexpr double kAreaPerObject = 3;
constexpr double kShore = 9;  // sites keep this far from the border, inside the rim
constexpr double kSiteSpacing = 3;
constexpr double kSiteHeight = 7;  // above the ground

// The seed of the landscape differs from that of the objects.
constexpr std::uint64_t kLandscapeStream = 0x7E44A1;

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = true,
                       .rotation = true,
                       .free_directions = true,
                       .separating = {true, false, true},
                       .contacts = true};

std::uint32_t tiles_for(std::uint32_t objects) {
  std::uint32_t tiles = kMinTiles;
  while (kTile * kTile * static_cast<double>(tiles) * tiles < kAreaPerObject * objects) tiles += 2;
  return tiles;
}

/// A tile and the middle of its frame.
struct Tile {
  std::shared_ptr<const Surface> surface;
  Vector<3> middle;
};

std::vector<Tile> make_tiles(const Hills& hills, std::uint32_t tiles) {
  const double half = 0.5 * kTile * tiles;
  std::vector<Tile> made;
  for (std::uint32_t k = 0; k < tiles; ++k) {
    for (std::uint32_t i = 0; i < tiles; ++i) {
      const double x = kTile * static_cast<double>(i) - half;
      const double z = kTile * static_cast<double>(k) - half;
      const Vector<3> middle{{static_cast<Scalar>(x + 0.5 * kTile), 0, static_cast<Scalar>(z + 0.5 * kTile)}};
      made.push_back({std::make_shared<const Surface>(hills.tile(x, z, kTile)), middle});
    }
  }
  return made;
}

Scalar lowest_point(std::span<const Tile> tiles) {
  Scalar lowest = std::numeric_limits<Scalar>::max();
  for (const Tile& tile : tiles)
    for (const Vector<3>& vertex : tile.surface->vertices) lowest = std::min(lowest, vertex[1]);
  return lowest;
}

Drop make_drop(const SceneOptions& options, const Hills& hills, double half, Scalar lowest) {
  Drop drop;
  drop.objects = options.objects;
  drop.steps = options.steps;
  drop.recycle = options.recycle;
  drop.nudge = options.nudge;
  const double reach = half - kShore;
  bool forward = true;  // each site is followed by a neighbour
  for (double z = -reach; z <= reach; z += kSiteSpacing, forward = !forward) {
    for (double along = -reach; along <= reach; along += kSiteSpacing) {
      const double x = forward ? along : -along;
      const double y = hills.height(x, z) + kSiteHeight;
      drop.sites.push_back({{static_cast<Scalar>(x), static_cast<Scalar>(y), static_cast<Scalar>(z)}});
    }
  }
  const auto border = static_cast<Scalar>(half);
  drop.inside = {{{-border, lowest - 1, -border}}, {{border, 1e6F, border}}};
  return drop;
}

std::unique_ptr<Scene<3>> make_terrain(BroadPhase<3>& broad_phase, const SceneOptions& options) {
  const SceneOptions resolved = resolve(options, kDefaultObjects, kDefaultSteps);
  const std::uint32_t side = tiles_for(resolved.objects);
  const double half = 0.5 * kTile * side;
  const Hills hills(half, Random(resolved.seed ^ kLandscapeStream));
  const std::vector<Tile> tiles = make_tiles(hills, side);
  const auto build = [&tiles](OdeWorld& world) {
    for (const Tile& tile : tiles) world.add_fixed(tile.surface, tile.middle);
  };
  return std::make_unique<DropScene>(broad_phase, kNeeds, resolved.seed,
                                     make_drop(resolved, hills, half, lowest_point(tiles)), build);
}

}  // namespace

SceneEntry<3> terrain_entry() {
  return {.name = "terrain",
          .summary = "spheres and blocks fall into hills made of many fixed tiles; their number grows",
          .source = "the paper's simulation 1",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_terrain};
}

}  // namespace kerf

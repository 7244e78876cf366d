
#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/scene_entries.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 600;
constexpr std::uint32_t kDefaultSteps = 400;
constexpr std::uint32_t kObjectsPerBucket = 70;  // about three units deep
constexpr std::uint32_t kMinSide = 2;            // buckets along one side of the square

constexpr Scalar kInner = 5;   // width of a bucket inside
constexpr Scalar kHeight = 4;  // of the walls above the floor, which lies at y = 0
constexpr Scalar kHalfWall = 0.25F;
constexpr Scalar kHalfFloor = 0.25F;
constexpr Scalar kGap = 1.5F;  // between the walls of two buckets
constexpr Scalar kPitch = kInner + 4 * kHalfWall + kGap;
// Tiles keep apart by a hair: a tree finds no room for a plane between rows of boxes that touch.
constexpr Scalar kHalfTile = kPitch / 2 - 0x1p-10F;
constexpr Scalar kApron = 2;           // of the outer tiles, between the buckets and the fence
constexpr Scalar kFenceHeight = 2.5F;  // low: spilled objects roll, and the buckets stay in view
constexpr Scalar kSite = 1.25F;        // from the middle of a bucket, along X and Z
constexpr Scalar kSiteHeight = 8;

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = true,
                       .rotation = true,
                       .free_directions = false,  // walls stand along the axes
                       .separating = {true, false, true},
                       .contacts = true};

/// Buckets along one side of a square that holds `objects`.
std::uint32_t side_for(std::uint32_t objects) {
  std::uint32_t side = kMinSide;
  while (std::uint64_t{side} * side * kObjectsPerBucket < objects) ++side;
  return side;
}

/// Middle of bucket i of `side` along X or Z; the square is centred on the origin.
Scalar middle(std::uint32_t i, std::uint32_t side) {
  return kPitch * (static_cast<Scalar>(i) - 0.5F * static_cast<Scalar>(side - 1));
}

/// From the middle of the square to the fence.
Scalar reach(std::uint32_t side) { return kPitch * static_cast<Scalar>(side) / 2 + kApron; }

/// Row by row, every other row backwards: each bucket is followed by a neighbour.
template <class Visit>
void for_each_bucket(std::uint32_t side, Visit visit) {
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t k = 0; k < side; ++k) {
      const Scalar x = middle(i, side);
      const Scalar z = middle(i % 2 == 0 ? k : side - 1 - k, side);
      visit(x, z);
    }
  }
}

void add_brick(OdeWorld& world, const Vector<3>& center, const Vector<3>& half) {
  world.add_fixed(Brick<3>{half}, center);
}

/// An interval by its middle and half its length.
struct Span {
  Scalar middle, half;
};

/// What tile i of `side` covers along X or Z.
Span tile_span(std::uint32_t i, std::uint32_t side) {
  const Scalar low = middle(i, side) - kHalfTile - (i == 0 ? kApron : 0);
  const Scalar high = middle(i, side) + kHalfTile + (i + 1 == side ? kApron : 0);
  return {(low + high) / 2, (high - low) / 2};
}

void add_tiles(OdeWorld& world, std::uint32_t side) {
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t k = 0; k < side; ++k) {
      const Span x = tile_span(i, side);
      const Span z = tile_span(k, side);
      add_brick(world, {{x.middle, -kHalfFloor, z.middle}}, {{x.half, kHalfFloor, z.half}});
    }
  }
}

void add_walls(OdeWorld& world, Scalar x, Scalar z) {
  constexpr Scalar kHalfHeight = kHeight / 2;
  constexpr Scalar kOffset = kInner / 2 + kHalfWall;
  constexpr Scalar kOuterHalf = kInner / 2 + 2 * kHalfWall;
  for (const Scalar sign : {-1.0F, 1.0F}) {
    add_brick(world, {{x + sign * kOffset, kHalfHeight, z}}, {{kHalfWall, kHalfHeight, kOuterHalf}});
    add_brick(world, {{x, kHalfHeight, z + sign * kOffset}}, {{kInner / 2, kHalfHeight, kHalfWall}});
  }
}

/// One panel for each bucket at the border, so that no object is as large as the scene.
void add_fence(OdeWorld& world, std::uint32_t side) {
  constexpr Scalar kHalfHeight = kFenceHeight / 2;
  const Scalar offset = reach(side) + kHalfWall;
  for (std::uint32_t i = 0; i < side; ++i) {
    const Span along = tile_span(i, side);
    for (const Scalar sign : {-1.0F, 1.0F}) {
      add_brick(world, {{sign * offset, kHalfHeight, along.middle}}, {{kHalfWall, kHalfHeight, along.half}});
      add_brick(world, {{along.middle, kHalfHeight, sign * offset}}, {{along.half, kHalfHeight, kHalfWall}});
    }
  }
}

Drop make_drop(const SceneOptions& options, std::uint32_t side) {
  Drop drop;
  drop.objects = options.objects;
  drop.steps = options.steps;
  drop.recycle = options.recycle;
  drop.nudge = options.nudge;
  for_each_bucket(side, [&drop](Scalar x, Scalar z) {
    for (const Scalar dx : {-kSite, kSite})
      for (const Scalar dz : {-kSite, kSite}) drop.sites.push_back({{x + dx, kSiteHeight, z + dz}});
  });
  const Scalar border = reach(side);
  drop.inside = {{{-border, -1, -border}}, {{border, 1e6F, border}}};
  return drop;
}

template <bool MaySleep>
std::unique_ptr<Scene<3>> make_buckets(BroadPhase<3>& broad_phase, const SceneOptions& options) {
  const SceneOptions resolved = resolve(options, kDefaultObjects, kDefaultSteps);
  const std::uint32_t side = side_for(resolved.objects);
  const auto build = [side](OdeWorld& world) {
    for_each_bucket(side, [&world](Scalar x, Scalar z) { add_walls(world, x, z); });
    add_tiles(world, side);
    add_fence(world, side);
  };
  Drop drop = make_drop(resolved, side);
  drop.physics.sleep.allowed = MaySleep;
  return std::make_unique<DropScene>(broad_phase, kNeeds, resolved.seed, std::move(drop), build);
}

}  // namespace

SceneEntry<3> buckets_entry() {
  return {.name = "buckets",
          .summary = "balls and bricks fall into open buckets and pile up; their number grows",
          .source = "the paper's simulation 4",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_buckets<true>};
}

SceneEntry<3> awake_buckets_entry() {
  SceneEntry<3> entry = buckets_entry();
  entry.name = "buckets-awake";
  entry.summary = "buckets in which no body falls asleep: every box moves in every step";
  entry.make = make_buckets<false>;
  return entry;
}

}  // namespace kerf

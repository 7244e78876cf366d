#include "frames/bench/bench_scene.h"

#include <algorithm>
#include <array>
#include <string>

#include "frames/bench/motions/attractors.h"
#include "frames/bench/motions/flights.h"
#include "frames/bench/motions/needles.h"
#include "frames/bench/motions/pile.h"
#include "frames/bench/motions/shapes.h"
#include "frames/support/errors.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

template <class M>
auto make(std::uint32_t count, std::uint64_t seed) -> std::unique_ptr<Motion<M::kDimension>> {
  return std::make_unique<M>(count, seed);
}

/// Straight flight by 0.75 of a usual extent a step, bouncing off the walls of the world.
template <int D>
struct Uniform final : Flight<D> {
  Uniform(std::uint32_t count, std::uint64_t seed) : Flight<D>(count, seed, side_for(count, D)) {}
};

/// Straight flight at a density of some fifty pairs an object.
template <int D>
struct Dense final : Flight<D> {
  Dense(std::uint32_t count, std::uint64_t seed) : Flight<D>(count, seed, side_for(count, D, 1, 50)) {}
};

/// A third of the objects falls onto heaps, which trickle down where they are steep. For each object that
/// lands, one is taken from the top and falls again.
template <int D>
struct Falling final : Pile<D> {
  Falling(std::uint32_t count, std::uint64_t seed) : Pile<D>(count, seed, {.in_air = 1.0 / 3, .heaps = 4}) {}
};

/// A pile four times as wide as high. Every object stirs by a small part of its size in each step, and one in
/// two thousand slides.
template <int D>
struct Settled final : Pile<D> {
  Settled(std::uint32_t count, std::uint64_t seed) : Pile<D>(count, seed, {.slides_one_in = 2000}) {}
};

/// Four buckets along each horizontal axis, with fixed walls and floors, into which a quarter of the objects
/// falls.
template <int D>
struct Buckets final : Pile<D> {
  Buckets(std::uint32_t count, std::uint64_t seed) : Pile<D>(count, seed, {.in_air = 0.25, .buckets = 4}) {}
};

constexpr std::array<BenchScene, 15> kScenes{
    {{"falling", "a third falls onto heaps", make<Falling<2>>, make<Falling<3>>},
     {"settled", "a pile that still stirs", make<Settled<2>>, make<Settled<3>>},
     {"brownian", "random walk by most of a size a step", make<Brownian<2>>, make<Brownian<3>>},
     {"uniform", "straight flight by most of a size a step", make<Uniform<2>>, make<Uniform<3>>},
     {"attractors", "dense clouds that collapse, swirl and mix", make<Attractors<2>>, make<Attractors<3>>},
     {"buckets", "falling into buckets with fixed walls", make<Buckets<2>>, make<Buckets<3>>},
     {"mostly-static", "one in twenty walks, the others rest", make<MostlyStatic<2>>, make<MostlyStatic<3>>},
     {"needles", "nearly diagonal, of length 1 to 8", make<Needles<2>>, make<Needles<3>>},
     {"teleport", "everything jumps in each step", make<Teleport<2>>, make<Teleport<3>>},
     {"flat", "a crowd on a plane of the world, in 2D along a line", make<FlatWorld<2>>, make<FlatWorld<3>>},
     {"dense", "fifty pairs an object", make<Dense<2>>, make<Dense<3>>},
     {"islands", "200 on each, far apart along the diagonal", make<Islands<2>>, make<Islands<3>>},
     {"rods", "sixty times as long as thick, along the axes", make<Rods<2>>, make<Rods<3>>},
     {"pauses", "all walk for 20 steps and rest for 40, in turns", make<Pauses<2>>, make<Pauses<3>>},
     {"shifts", "mostly static; the origin is moved in every tenth step", make<Shifts<2>>, make<Shifts<3>>}}};

}  // namespace

std::span<const BenchScene> bench_scenes() { return kScenes; }

const BenchScene& find_bench_scene(std::string_view name) {
  const auto found =
      std::find_if(kScenes.begin(), kScenes.end(), [&](const BenchScene& s) { return s.name == name; });
  if (found != kScenes.end()) return *found;
  std::vector<std::string> names;
  for (const BenchScene& scene : kScenes) names.emplace_back(scene.name);
  throw UsageError(unknown_name_message("scene", name, names));
}

}  // namespace kerf

#include "frames/bench/bench_scene.h"

#include <algorithm>
#include <array>
#include <string>

#include "frames/bench/motions/motions.h"
#include "frames/support/errors.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr std::array<BenchScene, 14> kScenes{
    {{"falling", "a third falls onto heaps", make_falling<2>, make_falling<3>},
     {"settled", "a pile that still stirs", make_settled<2>, make_settled<3>},
     {"brownian", "random walk by most of a size a step", make_brownian<2>, make_brownian<3>},
     {"uniform", "straight flight by most of a size a step", make_uniform<2>, make_uniform<3>},
     {"attractors", "dense clouds that collapse, swirl and mix", make_attractors<2>, make_attractors<3>},
     {"buckets", "falling into buckets with fixed walls", make_buckets<2>, make_buckets<3>},
     {"mostly-static", "one in twenty walks, the others rest", make_mostly_static<2>, make_mostly_static<3>},
     {"needles", "nearly diagonal, of length 1 to 8", make_needles<2>, make_needles<3>},
     {"teleport", "everything jumps in each step", make_teleport<2>, make_teleport<3>},
     {"flat", "a crowd on a plane of the world, in 2D along a line", make_flat<2>, make_flat<3>},
     {"dense", "fifty pairs an object", make_dense<2>, make_dense<3>},
     {"rods", "sixty times as long as thick, along the axes", make_rods<2>, make_rods<3>},
     {"pauses", "all walk for 20 steps and rest for 40, in turns", make_pauses<2>, make_pauses<3>},
     {"shifts", "mostly static; the origin is moved in every tenth step", make_shifts<2>, make_shifts<3>}}};

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

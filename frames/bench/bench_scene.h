#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "frames/bench/motion.h"

namespace kerf {

template <int D>
using MakeMotion = std::unique_ptr<Motion<D>> (*)(std::uint32_t count, std::uint64_t seed);

/// A scene of `kerf bench`: the same rule of motion in both dimensions. `count` includes fixed objects.
struct BenchScene {
  std::string_view name;
  std::string_view summary;
  MakeMotion<2> make_2d;
  MakeMotion<3> make_3d;

  template <int D>
  [[nodiscard]] std::unique_ptr<Motion<D>> make(std::uint32_t count, std::uint64_t seed) const {
    if constexpr (D == 2) {
      return make_2d(count, seed);
    } else {
      return make_3d(count, seed);
    }
  }
};

std::span<const BenchScene> bench_scenes();

/// Throws UsageError, with a suggestion, for an unknown name.
const BenchScene& find_bench_scene(std::string_view name);

}  // namespace kerf

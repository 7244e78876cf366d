#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "frames/bench/bench_scene.h"
#include "frames/catalog/scene_catalog.h"

namespace kerf {

/// The options of `kerf bench` as the user typed them; empty: not given.
struct BenchTexts {
  std::string scenes;
  std::string simulations;
  std::string objects;
  std::string dimensions;
  std::string algorithms;
  std::string threads;
  std::string rounds;
  std::string steps;
  std::string warm_up;
  std::string seed;
  std::string patience;
  std::string json;
  std::string random;
  std::string first;
  std::string most;
  bool trace = false;
  bool ablation = false;
  bool queries = false;
};

/// What to measure, every part of it checked.
struct BenchRequest {
  std::vector<const BenchScene*> scenes;
  std::vector<CatalogScene> simulations;  ///< instead of scenes: broad phases in the loop of these
  std::vector<std::uint32_t> objects{1000, 4250, 16000};
  std::vector<int> dimensions{2, 3};
  std::vector<std::string> algorithms;
  std::vector<unsigned> threads{1};
  std::uint32_t rounds = 3;
  std::uint32_t steps = 0;    ///< 0: by the number of objects
  std::uint32_t warm_up = 0;  ///< 0: by the number of objects
  std::uint64_t seed = 1;
  std::uint32_t patience = 30;
  std::uint32_t random = 0;        ///< instead of scenes: so many random ones; 0: none
  std::uint32_t first = 1;         ///< the first of them
  std::uint32_t most = 256000;     ///< objects that they have at most
  std::string measured_otherwise;  ///< of random scenes: the options given of how they are measured, with " "
  std::filesystem::path json;      ///< empty: none
  bool trace = false;
  bool ablation = false;  ///< the algorithms are the tuned tree, then the tree without each of its policies
  bool queries = false;   ///< instead of pairs: queries on the boxes of the scenes

  [[nodiscard]] std::uint32_t steps_for(std::uint32_t count) const;
  [[nodiscard]] std::uint32_t warm_up_for(std::uint32_t count) const;
};

/// Throws UsageError that says what to do.
BenchRequest parse_bench_request(const BenchTexts& texts);

}  // namespace kerf

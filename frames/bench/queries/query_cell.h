#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frames/bench/bench_scene.h"

namespace kerf {

/// Which queries to measure.
struct QueryPlan {
  const BenchScene* scene = nullptr;
  std::uint32_t objects = 0;
  std::uint32_t warm_up = 8;  ///< steps of the motion before
  std::uint32_t rounds = 9;
  std::uint32_t queries = 256;  ///< of each kind
  std::uint64_t seed = 1;
};

/// One structure's times for one kind of query.
struct QueryTime {
  std::string structure;
  double least_ns = 0;   ///< a query, or for the kinds "build" and "move" an object: of each few queries the
                         ///< least of all rounds counts
  double median_ns = 0;  ///< the same with the median of the rounds
  std::uint32_t differs = 0;  ///< queries with another answer
};

struct QueryRow {
  std::string scene;
  int dimension = 3;
  std::uint32_t objects = 0;
  std::string kind;
  double found = 0;              ///< a query, on average
  std::vector<QueryTime> times;  ///< ours first; without those that have no such query

  /// How often as long the fastest other library takes, without Embree.
  [[nodiscard]] std::optional<double> over_fastest() const;
  /// How often as long Embree takes, if it has such a query.
  [[nodiscard]] std::optional<double> over_embree() const;
};

/// All kinds of queries, and "build" and "move": to take over all boxes for the first time, and after a step.
/// All structures have their turn in each round. Ours is compared with a scan of all boxes, the others with
/// ours. `goes_on` is asked between kinds.
template <int D>
std::vector<QueryRow> measure_queries(const QueryPlan& plan, const std::function<bool()>& goes_on);

}  // namespace kerf

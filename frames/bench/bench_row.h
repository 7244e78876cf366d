#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kerf {

/// The identity of a cell: the same boxes at the same time.
struct CellName {
  std::string scene;
  int dimension = 3;
  std::uint32_t objects = 0;
  unsigned threads = 1;
};

/// The measurement of one algorithm. Times are nanoseconds an object and step; the least of the rounds counts
/// for each step, since other work on the machine only ever adds.
struct BenchRow {
  CellName cell;
  std::string algorithm;
  double median_ns = 0;
  double p90_ns = 0;
  double p99_ns = 0;
  double max_ns = 0;
  double native_ns = 0;      ///< the median of the library's own cost (see AddedWork)
  double build_ns = 0;       ///< to insert an object, and the first step
  std::uint64_t pairs = 0;   ///< a step, on average
  std::uint64_t missed = 0;  ///< in all measured steps; of each the most of the rounds
  std::uint64_t extra = 0;   ///< likewise
  double times_floor = 0;    ///< the median over that of the floor
  std::uint64_t rss_bytes = 0;
  std::optional<double> tests_per_pair;  ///< of the last step; none: not asked for, or unknown
  std::uint32_t steps = 0;               ///< measured
  std::vector<double> round_ns;          ///< of each complete round the median over its steps
  std::vector<float> step_ns;            ///< one by one, if requested
};

/// An algorithm without a row, or with one of fewer steps, and the reason.
struct BenchGap {
  CellName cell;
  std::string algorithm;
  std::string reason;
};

/// How much longer one algorithm takes than another, round by round, of rounds measured in turns.
struct RoundRatio {
  double median = 1;
  double least = 1;
  double most = 1;
};
/// The times of `row` over those of `base`. Both need a round.
RoundRatio ratio_of_rounds(const BenchRow& row, const BenchRow& base);
/// The median of the rounds; 0 if there is none.
double median_round(const BenchRow& row);

/// Takes the figures an object as those of so many objects.
void share_among(BenchRow& row, std::uint32_t objects);

/// Sorts the times of the steps and sets `median_ns` to `max_ns` from them.
void set_times(BenchRow& row, std::vector<double> each);

/// The value that `share` of the sorted numbers do not exceed (nearest rank); 0 if there are none.
double percentile(const std::vector<double>& sorted, double share);

}  // namespace kerf

#pragma once

#include <string>
#include <vector>

#include "frames/bench/bench_cell.h"

namespace kerf {

/// A broad phase that reported the complete pairs of every step.
struct Standing {
  BenchRow row;
  RoundRatio times;       ///< its time over that of the fastest
  bool is_level = false;  ///< in some round it was as fast as the fastest
  bool is_library = false;
};

/// Which broad phase to choose for a scene.
struct Advice {
  std::vector<Standing> standings;     ///< the fastest first
  std::vector<BenchRow> wrong;         ///< those that missed or invented pairs
  std::vector<BenchGap> left_out;      ///< those that were too slow or failed
  std::vector<std::string> sentences;  ///< what to choose and why; one at least
};

/// Judges what was measured in turns, at least two rounds of it. The floor takes no part.
Advice advise(const CellResult& cell);

/// "1.32", three digits.
std::string times_text(double times);
/// Milliseconds that a step of all objects takes.
double step_milliseconds(const BenchRow& row);
/// Nanoseconds of it for an object: the median of the rounds, by which broad phases are compared.
double step_ns(const BenchRow& row);

}  // namespace kerf

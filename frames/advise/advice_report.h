#pragma once

#include <cstdint>
#include <string>

#include "frames/advise/advice.h"
#include "frames/support/step_range.h"

namespace kerf {

/// What was measured on a recording.
struct AdvisedRecording {
  std::string file;
  int dimension = 3;
  StepRange steps;         ///< by the recording's count
  std::string steps_text;  ///< as the recording names them
  std::uint32_t rounds = 0;
  CellPlan plan;
  CellResult cell;
  Advice advice;
};

/// The scene, a line for each broad phase, and the advice.
std::string advice_text(const AdvisedRecording& advised);

/// {"machine", "file", "dim", "steps", "warm_up", "rounds", "scene": properties, "results": [rows as those of
/// `kerf bench`, with "times", "times_least", "times_most" of the right ones], "gaps", "advice": [sentences]}
std::string advice_json(const AdvisedRecording& advised);

/// The times as bars, an SVG file. Throws std::runtime_error if gnuplot does not draw.
std::string advice_plot(const AdvisedRecording& advised);

}  // namespace kerf

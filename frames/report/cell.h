#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

/// Figures, as they are kept and shown: objects of numbers and words.
using Json = nlohmann::ordered_json;

/// To be called often by whoever works long: throws Interrupted when the user wants to stop.
using Poll = std::function<void()>;

/// One thing to be measured. Its result is kept under its key, so that a run that was stopped goes on where
/// it was, and sections that show the same figures measure them once.
struct Cell {
  std::string key;  ///< what is measured, with all that the result depends on
  std::function<Json(const Poll& poll)> measure;
  double work = 1;  ///< how long that takes, beside other cells
};

}  // namespace kerf

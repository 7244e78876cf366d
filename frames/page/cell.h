#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

/// Figures, as they are kept and shown: objects of numbers and words.
using Json = nlohmann::ordered_json;

/// To be called often by whoever works long: throws Interrupted when the user wants to stop.
using Poll = std::function<void()>;

/// The work of a run of so many objects and steps that takes `seconds` with 1,000 and 100 of them.
inline double work_of(double seconds, std::uint32_t objects, std::uint32_t steps) {
  return seconds * objects / 1000 * steps / 100;
}

/// One thing to be measured. Its result is kept under its key, so that a run that was stopped goes on where
/// it was, and sections that show the same figures measure them once.
struct Cell {
  std::string key;  ///< what is measured, with all that the result depends on
  std::function<Json(const Poll& poll)> measure;
  double work = 1;  ///< about how many seconds that takes, to tell the time left
};

}  // namespace kerf

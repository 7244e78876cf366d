#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "frames/page/json.h"

namespace kerf {

/// Long work calls this often: throws Interrupted when the user stops the program.
using Poll = std::function<void()>;

/// The work of a run of so many objects and steps that takes `seconds` with 1,000 and 100 of them.
inline double work_of(double seconds, std::uint32_t objects, std::uint32_t steps) {
  return seconds * objects / 1000 * steps / 100;
}

/// One measurement. Its result is kept under its key, so that an interrupted run continues where it was, and
/// sections that show the same figures measure them once.
struct Cell {
  std::string key;  ///< what is measured, with everything that the result depends on
  std::function<Json(const Poll& poll)> measure;
  double work = 1;  ///< about how many seconds it takes, for the estimate of the time left
};

}  // namespace kerf

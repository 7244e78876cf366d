#pragma once

#include <filesystem>

#include "core/base/config.h"

namespace kerf {

/// Another engine's run as plain text (see `kerf import --help`).
struct ImportRequest {
  std::filesystem::path boxes;
  std::filesystem::path pairs;  ///< empty: none
  std::filesystem::path out;
  Config config;  ///< of the tree that runs beside
};

/// Plays the boxes to a tree, records it, judges their pairs by the definition and prints what is wrong with
/// them. Throws UsageError that names file and line, or std::runtime_error if a file cannot be read or
/// written.
void import_boxes(const ImportRequest& request);

}  // namespace kerf

#pragma once

#include <filesystem>

#include "core/base/config.h"
#include "core/geometry/given_box.h"
#include "frames/support/interrupt.h"

namespace kerf {

/// Another engine's run as plain text (see `kerf import --help`).
struct ImportRequest {
  std::filesystem::path boxes;      ///< "-": standard input
  std::filesystem::path pairs;      ///< empty: none
  std::filesystem::path objects;    ///< names, colours and shapes; empty: none
  std::filesystem::path ignore;     ///< pairs that are not judged; empty: none
  std::filesystem::path structure;  ///< nodes of their tree; empty: not known
  std::filesystem::path out;
  Config config;  ///< of the tree that runs beside
  Margin margin;
  bool unite = false;   ///< several boxes of an object in a step become one
  bool strict = false;  ///< what is odd is an error
};

/// Plays the boxes to a tree, records it, judges their pairs by the definition, checks their structure and
/// prints what was understood, what is odd and what is wrong. Throws UsageError that names file and line, or
/// std::runtime_error if a file cannot be read or written, or Interrupted.
void import_boxes(const ImportRequest& request, const InterruptGuard& interrupt);

}  // namespace kerf

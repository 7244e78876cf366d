#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "frames/study/cell_file.h"
#include "frames/support/outputs.h"

namespace kerf {

/// What came of a cell.
struct StudyResult {
  Figures figures;
  std::string trouble;  ///< why there are none; empty: they are there
};

/// A cell without figures, and the reason.
struct Failure {
  std::string id;
  std::string reason;
};

/// Callbacks of a running study.
struct StudyWatch {
  std::function<void(const StudyCell&)> begin;
  std::function<bool()> stop;
};

/// Measures a cell in a process of its own, so that no cell finds what another one has left in memory, and a
/// library's crash ends its cell alone; so it does when `stop` becomes true. `folder` is for frames.
StudyResult measure_apart(const StudyCell& cell, const std::filesystem::path& folder, Replace replace,
                          const std::function<bool()>& stop);

/// The cells that have no file in the folder yet, or, with `overwrite`, all. Throws UsageError, as Outputs
/// does, if another file has the name of one of their files.
std::vector<const StudyCell*> cells_to_do(const std::vector<const StudyCell*>& cells,
                                          const std::filesystem::path& folder, bool overwrite);

/// Measures cells one by one, and writes each to its file in `folder`; one that another process has written
/// meanwhile is left as it is. Throws Interrupted, which says what is
/// kept, when the watch says stop, and std::system_error if a file cannot be written.
std::vector<Failure> run_cells(const Study& study, const std::vector<const StudyCell*>& cells,
                               const std::filesystem::path& folder, Replace replace, const StudyWatch& watch);

}  // namespace kerf

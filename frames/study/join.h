#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/study/cell_file.h"

namespace kerf {

/// The cells of a study from the folders of its shards.
struct JoinedStudy {
  /// A cell and the folder that has it.
  struct Cell {
    const StudyCell* cell = nullptr;
    CellFile file;
    std::filesystem::path folder;
  };
  std::vector<Cell> cells;                ///< in the order of the study, without those that are missing
  std::vector<const StudyCell*> missing;  ///< likewise
  std::size_t doubles = 0;                ///< files with the same counts as an earlier folder's
  std::size_t strangers = 0;              ///< files of cells that are not in the study (any more)
};

/// Reads all folders. Of a cell that several of them have, the first one's figures count. Throws
/// std::runtime_error, with all of them, if two folders have different counts of a cell, and if the file of a
/// cell is damaged or its pictures, which are all read, those of doubles as well, are not those that were
/// drawn; UsageError if a folder is none.
JoinedStudy join(const Study& study, const std::vector<std::filesystem::path>& folders);

/// "3 of 200 cells are missing: ..., ...; this makes them: kerf study ...". Empty if none is.
std::string describe_missing(const Study& study, const JoinedStudy& joined);

/// A hash of all settings and counts: joined from whatever shards, the same.
std::uint64_t counts_hash(const JoinedStudy& joined);

/// Puts the frames of each matrix of frames into one sequence, `folder`/NAME, if no part of it is missing.
/// Returns the sequences. Throws as `collect` and `gather` do.
std::vector<std::filesystem::path> gather_frames(const JoinedStudy& joined,
                                                 const std::filesystem::path& folder, bool overwrite);

}  // namespace kerf

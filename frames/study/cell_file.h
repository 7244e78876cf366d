#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frames/study/measure.h"

namespace kerf {

/// The figures of a cell, the machine that measured them, and the command that measures them again, in a file
/// of its own.
struct CellFile {
  std::string id;
  Json settings;
  Figures figures;
  std::string machine;  ///< processor, and the version of kerf
  std::string command;
};

/// The name of a cell's file in the folder of a study, and of the folder in which a cell of frames renders.
std::filesystem::path cell_path(const std::filesystem::path& folder, const StudyCell& cell);
std::filesystem::path frames_path(const std::filesystem::path& folder, const StudyCell& cell);

CellFile make_cell_file(const Study& study, const StudyCell& cell, Figures figures);
std::string to_json(const CellFile& file);

/// Whether two values are equal, whatever the order of their keys: other programs may have written them anew.
bool is_equal(const Json& a, const Json& b);

/// None if the file is not one that `to_json` gives, or not there.
std::optional<CellFile> read_cell_file(const std::filesystem::path& file);
/// None if it is not the file of that cell, either, or lacks a figure that the cell measures or a picture
/// that it has rendered.
std::optional<CellFile> read_cell_file(const std::filesystem::path& file, const StudyCell& cell);
/// The first picture, or the manifest, that the file of a cell of frames counts and that is gone; empty if
/// none is, or if it is not the file of that cell.
std::string lost_picture(const std::filesystem::path& file, const StudyCell& cell);

}  // namespace kerf

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::house {

/// An #include that the house does not allow.
struct Violation {
  std::string file;  ///< path from the project's root
  int line = 0;      ///< counted from 1
  std::string reason;
};

/// A folder of a room and how high it stands in it: it may include what is lower.
struct Layer {
  std::string_view folder;  ///< path from the project's root, with the slash at its end
  int height = 0;
};

/// The layers of every room that has some, lowest first.
std::span<const Layer> layers();

/// "file:line: reason", as compilers write it.
std::string to_string(const Violation& violation);

/// Checks every #include of the given C++ files (paths relative to `root`) against the table of rooms in
/// DESIGN.md and against `layers()`. Needed because GL, Box2D and ODE share one system folder, so that
/// linking cannot stop a leak. Where X.cpp has an X.h it must include it first: so each build sees that X.h
/// compiles alone (`kerf_room`). Throws std::runtime_error for a file that cannot be read.
std::vector<Violation> check_includes(const std::filesystem::path& root,
                                      std::span<const std::filesystem::path> files);

}  // namespace kerf::house

#pragma once

#include <filesystem>
#include <optional>
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

/// A folder of a room and its height in that room: a layer may include lower ones.
struct Layer {
  std::string_view folder;  ///< path from the project's root, with the slash at its end
  int height = 0;
  std::string_view purpose;  ///< what the layer holds, for docs/ARCHITECTURE.md
};

/// An #include line of a file.
struct Include {
  int line = 0;        ///< counted from 1
  std::string header;  ///< empty when the line does not name one
  bool quoted = false;
};

/// The top-level folders that hold C++.
std::span<const std::string_view> rooms();

/// The layers of every room that has some, lowest first.
std::span<const Layer> layers();

/// The layer of a file: the longest matching prefix counts. Null for a file of a room without layers.
const Layer* layer_of(std::string_view file);

/// The room or library that a header belongs to, given the text between quotes or angle brackets.
std::optional<std::string_view> owner_of(std::string_view header);

/// The #include lines of a file, in order. Throws std::runtime_error when it cannot be read.
std::vector<Include> includes_of(const std::filesystem::path& file);

/// "file:line: reason", as compilers write it.
std::string to_string(const Violation& violation);

/// Checks every #include of the given C++ files (paths relative to `root`) against what each room may include
/// and against `layers()`. Linking cannot stop a leak, because GL, Box2D and ODE share one system folder.
/// Where X.cpp has an X.h it must include it first: so each build shows that X.h compiles alone
/// (`kerf_room`). Throws std::runtime_error for a file that cannot be read.
std::vector<Violation> check_includes(const std::filesystem::path& root,
                                      std::span<const std::filesystem::path> files);

}  // namespace kerf::house

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace kerf::faults {

/// How a test sees that an output is the new one and whole: a file with times in it is never the same twice.
/// A manifest may also say that it is not complete; then each of its frames may be an earlier one.
enum class Likeness { same_bytes, same_manifest, same_recording, same_lines, same_end };

struct OutputFile {
  std::string name;  ///< within the scenario's folder
  Likeness likeness = Likeness::same_bytes;
};

/// A run of `kerf` that replaces earlier outputs. All files lie in one folder.
struct Scenario {
  std::string name;
  /// Makes the inputs and the earlier outputs in an empty folder.
  std::function<void(const std::filesystem::path&)> prepare;
  /// Of the run, in such a folder.
  std::function<std::vector<std::string>(const std::filesystem::path&)> arguments;
  std::vector<OutputFile> outputs;
};

/// Over all commands whose outputs are built in a way of their own.
const std::vector<Scenario>& scenarios();

}  // namespace kerf::faults

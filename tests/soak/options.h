#pragma once

#include <cstdint>
#include <filesystem>

namespace kerf::test {

/// The options of programs that try for a given time.
struct SoakOptions {
  double minutes = 1;
  std::uint64_t seed = 1;
  std::filesystem::path json;  ///< where the figures go; empty: nowhere
  std::filesystem::path keep;  ///< folder for inputs that found something; empty: here
};

/// Reads `--minutes M --seed S --json FILE --keep FOLDER`, any of them. Ends the program with a message if it
/// cannot.
SoakOptions soak_options(int argc, char** argv);

}  // namespace kerf::test

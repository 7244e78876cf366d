#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace kerf::test {

/// The bytes of one fuzz case.
using CaseBytes = std::span<const std::uint8_t>;

/// A case that is kept, with the name of its file.
struct KeptCase {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// The cases kept for a fuzz target, below tests/fuzz/corpus/.
inline std::vector<KeptCase> corpus(const std::filesystem::path& source_folder, const std::string& target) {
  std::vector<KeptCase> cases;
  for (const auto& entry :
       std::filesystem::directory_iterator(source_folder / "tests/fuzz/corpus" / target)) {
    std::ifstream file(entry.path(), std::ios::binary);
    cases.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(file), {}}});
  }
  return cases;
}

}  // namespace kerf::test

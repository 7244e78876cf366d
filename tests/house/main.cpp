// kerf_architecture: draws the house from the linter's table and the #include lines (docs/ARCHITECTURE.md).
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "tests/house/architecture.h"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

int main() {
  try {
    const std::filesystem::path root = KERF_SOURCE_DIR;
    for (const auto& [file, text] : kerf::house::architecture_files(root)) write(root / file, text);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kerf_architecture: %s\n", error.what());
    return 1;
  }
}

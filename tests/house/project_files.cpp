#include "tests/house/project_files.h"

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace kerf::house {
namespace {

std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output.push_back(static_cast<char>(c));
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return output;
}

}  // namespace

std::vector<std::filesystem::path> project_files() {
  // The check-out may belong to another user than the tester's; git would refuse to read it.
  std::istringstream list(output_of("git -c safe.directory='*' -C '" KERF_SOURCE_DIR
                                    "' ls-files --cached --others --exclude-standard"));
  std::vector<std::filesystem::path> files;
  for (std::string name; std::getline(list, name);) {
    if (std::filesystem::is_regular_file(std::filesystem::path(KERF_SOURCE_DIR) / name))
      files.emplace_back(name);
  }
  return files;
}

std::vector<std::filesystem::path> source_files() {
  std::vector<std::filesystem::path> files = project_files();
  std::erase_if(files,
                [](const auto& file) { return file.extension() != ".h" && file.extension() != ".cpp"; });
  return files;
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream text(std::filesystem::path(KERF_SOURCE_DIR) / file, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (line.find('\0') != std::string::npos) return {};
    lines.push_back(line);
  }
  return lines;
}

}  // namespace kerf::house

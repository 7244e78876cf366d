#include <fstream>
#include <stdexcept>

#include "frames/sequence/manifest.h"
#include "frames/support/scratch_folder.h"
#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

void write(const std::filesystem::path& folder, const std::string& text) {
  std::ofstream(folder / kManifestName, std::ios::binary) << text;
}

}  // namespace

std::string manifest_case(CaseBytes bytes) {
  static const ScratchFolder folder;
  write(folder.path(), std::string(bytes.begin(), bytes.end()));
  try {
    const std::string text = to_json(read_manifest(folder.path()));
    write(folder.path(), text);
    return to_json(read_manifest(folder.path())) == text ? "" : "written again, it is another";
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).find(kManifestName) == std::string::npos
               ? "an error that does not name the file: " + std::string(error.what())
               : "";
  }
}

}  // namespace kerf::test

#include <fstream>
#include <stdexcept>

#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/scratch_folder.h"
#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

/// A frame whose ids are there, and whose draw list each case writes anew.
std::filesystem::path frame() {
  static const ScratchFolder folder;
  const std::filesystem::path frame = folder.path() / "a.png";
  StoredIds stored;
  stored.ids.image = {2, 2, std::vector<std::uint8_t>(16, 0)};
  if (!std::filesystem::exists(ids_path(frame))) write_ids(frame, stored);
  return frame;
}

}  // namespace

std::string draw_list_case(CaseBytes bytes) {
  const std::filesystem::path drawn = frame();
  std::ofstream(draw_list_path(drawn), std::ios::binary) << std::string(bytes.begin(), bytes.end());
  try {
    const auto stored = read_ids(drawn);
    if (!stored) return "there is a draw list, and none is read";
    for (const Drawn& item : stored->ids.list.items)
      if (name_of(item).empty()) return "an item without a name";
    return "";
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).find("a.draw.json") == std::string::npos
               ? "an error that does not name the file: " + std::string(error.what())
               : "";
  }
}

}  // namespace kerf::test

#include "tests/images/reference_frames.h"

#include <cstdlib>

#include "frames/diff/diff_result.h"
#include "viz/image/png.h"

namespace kerf::test {

namespace fs = std::filesystem;

fs::path reference_folder() { return fs::path(KERF_SOURCE_DIR) / "frames/reference"; }

fs::path new_folder() {
  const char* chosen = std::getenv("KERF_NEW_FRAMES");
  return chosen != nullptr ? fs::path(chosen) : fs::path(KERF_BUILD_DIR) / "images";
}

std::string compare_with_reference(const std::string& name, const Image& image, const StoredIds& ids) {
  fs::create_directories(new_folder());
  const FramePair frame{name + ".png", reference_folder() / (name + ".png"), new_folder() / (name + ".png")};
  write_png(frame.test, image);
  write_ids(frame.test, ids);
  DiffResult result{reference_folder(), new_folder(), {}, {}, {}, {}};
  if (fs::exists(frame.reference)) {
    result.frames.push_back(diff_frame(frame, {}));
  } else {
    result.frames.push_back(diff_frame({frame.name, {}, frame.test}, {}));
  }
  if (result.is_same()) return "";
  const std::string folders = result.reference.string() + " " + result.test.string();
  return to_text(result) + "to look at it:  kerf diff " + folders + " --report out/diff" +
         "\nif it is right: kerf diff " + folders + " --approve\n";
}

}  // namespace kerf::test

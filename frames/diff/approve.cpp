#include "frames/diff/approve.h"

#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

/// Ids that no longer belong to the picture must not stay beside it.
void copy_or_remove(const fs::path& from, const fs::path& to) {
  if (fs::exists(from)) {
    copy_file_atomically(from, to);
  } else {
    fs::remove(to);
  }
}

bool is_to_be_approved(const FrameDiff& diff) { return !diff.same && !diff.frame.is_missing(); }

void check(const fs::path& frame) {
  try {
    (void)read_png(frame);
    (void)read_ids(frame);
  } catch (const std::runtime_error& error) {
    throw UnusableInput(std::string(error.what()) + "; nothing was approved");
  }
}

}  // namespace

std::vector<std::string> approve_frames(const DiffResult& result) {
  for (const FrameDiff& diff : result.frames)
    if (is_to_be_approved(diff)) check(diff.frame.test);
  std::vector<std::string> approved;
  for (const FrameDiff& diff : result.frames) {
    if (!is_to_be_approved(diff)) continue;
    fs::path to = diff.frame.reference;
    if (diff.frame.is_extra())
      to = fs::is_directory(result.test) ? result.reference / diff.frame.name : result.reference;
    if (to.has_parent_path()) fs::create_directories(to.parent_path());
    // The picture last: after an interruption in between the difference is still found.
    copy_or_remove(ids_path(diff.frame.test), ids_path(to));
    copy_or_remove(draw_list_path(diff.frame.test), draw_list_path(to));
    copy_file_atomically(diff.frame.test, to);
    approved.push_back(diff.frame.name);
  }
  return approved;
}

}  // namespace kerf

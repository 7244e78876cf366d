#include "frames/diff/approve.h"

#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

/// What is replaced keeps its permissions; where it is a link, that stays and what it leads to is replaced.
void replace(const fs::path& from, const fs::path& to) {
  if (!fs::exists(to)) return copy_file_atomically(from, to);
  const fs::path target = fs::canonical(to);
  const fs::perms permissions = fs::status(target).permissions();
  copy_file_atomically(from, target);
  fs::permissions(target, permissions);
}

/// Ids that no longer belong to the picture must not stay beside it.
void replace_or_remove(const fs::path& from, const fs::path& to) {
  if (fs::exists(from)) {
    replace(from, to);
  } else {
    fs::remove(to);
  }
}

/// "x.png", and where it was put if that is elsewhere.
std::string name_of(const FrameDiff& diff, const fs::path& to) {
  return diff.frame.name + (fs::is_symlink(to) ? " (a link to " + fs::canonical(to).string() + ")" : "");
}

bool is_to_be_approved(const FrameDiff& diff) { return !diff.same && !diff.frame.is_missing(); }

void check(const fs::path& frame) {
  try {
    (void)read_stored_picture(frame);
    (void)read_ids(frame);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + "; nothing was approved");
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
    // The picture last: whoever stops in between still finds a difference.
    replace_or_remove(ids_path(diff.frame.test), ids_path(to));
    replace_or_remove(draw_list_path(diff.frame.test), draw_list_path(to));
    replace(diff.frame.test, to);
    approved.push_back(name_of(diff, to));
  }
  return approved;
}

}  // namespace kerf

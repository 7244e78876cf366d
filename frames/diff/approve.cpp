#include "frames/diff/approve.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "core/files/part_file.h"
#include "core/files/whole_file.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/errors.h"
#include "frames/support/outputs.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

/// Builds the new files of one frame beside their references before one of those is replaced. Ids that no
/// longer belong to the picture must not stay beside it. The picture comes last: after an
/// interruption in between the difference is still found.
void replace(const fs::path& test, const fs::path& reference) {
  std::vector<std::unique_ptr<PartFile>> parts;
  std::vector<fs::path> outdated;
  const auto add = [&](const fs::path& from, const fs::path& to) {
    if (!fs::exists(from)) return outdated.push_back(to);
    parts.push_back(std::make_unique<PartFile>(to));
    parts.back()->write(read_whole_file(from));
  };
  add(ids_path(test), ids_path(reference));
  add(draw_list_path(test), draw_list_path(reference));
  add(test, reference);
  for (const fs::path& file : outdated) fs::remove(file);
  for (const auto& part : parts) part->keep();
}

fs::path reference_of(const FrameDiff& diff, const DiffResult& result) {
  if (!diff.frame.is_extra()) return diff.frame.reference;
  return fs::is_directory(result.test) ? result.reference / diff.frame.name : result.reference;
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

std::vector<std::string> approve_frames(const DiffResult& result, const std::function<bool()>& stop) {
  Outputs outputs({}, true);
  for (const FrameDiff& diff : result.frames) {
    if (!is_to_be_approved(diff)) continue;
    if (stop && stop()) return {};
    check(diff.frame.test);
    outputs.add_file(reference_of(diff, result));
  }
  std::vector<std::string> approved;
  for (const FrameDiff& diff : result.frames) {
    if (!is_to_be_approved(diff)) continue;
    if (stop && stop()) break;
    const fs::path to = reference_of(diff, result);
    if (to.has_parent_path()) fs::create_directories(to.parent_path());
    replace(diff.frame.test, to);
    approved.push_back(name_of(diff, to));
  }
  return approved;
}

std::vector<std::string> approve_manifests(const DiffResult& result) {
  std::vector<std::string> approved;
  Outputs outputs({}, true);
  for (const ManifestDiff& manifest : result.manifests) {
    const fs::path to = result.reference / manifest.name;
    const bool lacks_a_frame = std::ranges::any_of(result.frames, [&](const FrameDiff& diff) {
      return diff.frame.is_missing() && diff.frame.reference.parent_path() == to.parent_path();
    });
    if (manifest.test.empty() || lacks_a_frame) continue;
    outputs.add_file(to);
    PartFile part(to);
    part.write(read_whole_file(manifest.test));
    part.keep();
    approved.push_back(manifest.name);
  }
  return approved;
}

}  // namespace kerf

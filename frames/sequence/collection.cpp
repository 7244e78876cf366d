#include "frames/sequence/collection.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "core/base/counted.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sequence_folder.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/folder_lock.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

void check_same_sequence(const Manifest& first, const std::filesystem::path& first_folder,
                         const Manifest& other, const std::filesystem::path& folder) {
  std::string difference = first_difference(first.header, other.header);
  if (difference.empty() && first.shard.count != other.shard.count)
    difference = "shards: " + std::to_string(first.shard.count) + " and " + std::to_string(other.shard.count);
  if (difference.empty()) return;
  throw UsageError(first_folder.string() + " and " + folder.string() + " are not of one sequence (" +
                   difference + ")");
}

void take(const FrameRecord& record, const std::filesystem::path& folder,
          std::map<std::uint32_t, CollectedFrame>& frames) {
  const std::filesystem::path path = folder / record.file;
  const auto [known, is_new] = frames.emplace(record.index, CollectedFrame{record, path, {}});
  if (is_new) return;
  if (known->second.record.pixel_hash != record.pixel_hash)
    throw std::runtime_error(known->second.path.string() + " and " + path.string() +
                             " should be the same picture and are not; render one of the shards again");
  known->second.others.push_back(path);
}

/// "0-3, 7, 9-12", and no more than a few of them.
std::string ranges_of(const std::vector<std::uint32_t>& numbers) {
  constexpr int kMost = 8;
  std::string text;
  int ranges = 0;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (++ranges > kMost) return text + " and more";
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
    if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
    i = end;
  }
  return text;
}

/// `shards`: those that have the frames, of so many.
std::string how_to_make(const std::set<std::uint32_t>& shards, std::uint32_t count, bool has_ids) {
  if (count == 1)
    return "; the same `kerf render` with " + std::string(has_ids ? "--ids and " : "") +
           "--resume makes them";
  std::string text =
      "; `kerf render` makes them with " + std::string(has_ids ? "--ids, " : "") + "--resume and --shard";
  for (const std::uint32_t shard : shards)
    text += (shard == *shards.begin() ? " " : ", ") + std::to_string(shard + 1) + "/" + std::to_string(count);
  return text;
}

/// A hard link, or a copy where that is impossible.
void put(const std::filesystem::path& file, const std::filesystem::path& target) {
  std::error_code cannot_link;
  std::filesystem::create_hard_link(file, target, cannot_link);
  if (cannot_link) copy_file_atomically(file, target);
}

void put_frames(const Collection& collection, const std::filesystem::path& folder) {
  for (const CollectedFrame& frame : collection.frames) {
    const std::filesystem::path to = folder / frame.record.file;
    put(frame.path, to);
    for (const auto beside : {ids_path, draw_list_path})
      if (std::filesystem::exists(beside(frame.path))) put(beside(frame.path), beside(to));
  }
}

bool has_files_beside(const std::filesystem::path& frame) {
  return std::filesystem::exists(ids_path(frame)) || std::filesystem::exists(draw_list_path(frame));
}

bool has_files_beside(const CollectedFrame& frame) {
  return has_files_beside(frame.path) ||
         std::ranges::any_of(frame.others, [](const auto& other) { return has_files_beside(other); });
}

/// What `read` says of files; empty: nothing.
template <class Read>
std::string trouble_of(std::initializer_list<std::filesystem::path> files, Read read) {
  for (const std::filesystem::path& file : files)
    if (!std::filesystem::exists(file)) return file.string() + " is missing";
  try {
    return read();
  } catch (const std::runtime_error& error) {
    for (const std::filesystem::path& file : files)
      if (!std::ifstream(file)) throw;
    return error.what();
  }
}

std::string trouble_with_picture(const std::filesystem::path& path, const FrameRecord& record, Image& image) {
  return trouble_of({path}, [&]() -> std::string {
    image = read_png(path);
    return pixel_hash(image) == record.pixel_hash ? ""
                                                  : path.string() + " has not the pixels that were drawn";
  });
}

std::string trouble_beside(const std::filesystem::path& path, const Image& image) {
  return trouble_of({ids_path(path), draw_list_path(path)}, [&]() -> std::string {
    const Image ids = read_ids(path)->ids.image;
    return ids.width == image.width && ids.height == image.height
               ? ""
               : ids_path(path).string() + " has another size than its frame";
  });
}

}  // namespace

Collection collect(const std::vector<std::filesystem::path>& folders) {
  Collection collection;
  std::map<std::uint32_t, CollectedFrame> frames;
  for (const std::filesystem::path& folder : folders) {
    const Manifest manifest = read_manifest(folder);
    if (collection.folders++ == 0) {
      collection.manifest = manifest;
    } else {
      check_same_sequence(collection.manifest, folders.front(), manifest, folder);
    }
    for (const FrameRecord& record : manifest.frames) take(record, folder, frames);
  }
  collection.manifest.frames.clear();
  for (auto& [index, frame] : frames) {
    collection.manifest.frames.push_back(frame.record);
    collection.has_ids = collection.has_ids || has_files_beside(frame);
    collection.frames.push_back(std::move(frame));
  }
  collection.manifest.complete = collection.is_complete();
  return collection;
}

std::string describe_gaps(const Collection& collection) {
  std::set<std::uint32_t> there;
  for (const CollectedFrame& frame : collection.frames) there.insert(frame.record.index);
  const std::uint32_t count = collection.manifest.shard.count;
  std::vector<std::uint32_t> missing;
  std::set<std::uint32_t> shards;
  for (std::uint32_t index = 0; index < collection.manifest.steps.frames(); ++index) {
    if (there.contains(index)) continue;
    missing.push_back(index);
    shards.insert(index % count);
  }
  if (missing.empty()) return "";
  return counted_of(missing.size(), collection.manifest.steps.frames(), "frame") +
         " missing: " + ranges_of(missing) + how_to_make(shards, count, collection.has_ids);
}

std::string trouble_with(CollectedFrame& frame, bool has_ids, Image& image) {
  std::vector<std::filesystem::path> paths{frame.path};
  paths.insert(paths.end(), frame.others.begin(), frame.others.end());
  std::string troubles;
  for (const std::filesystem::path& path : paths) {
    std::string trouble = trouble_with_picture(path, frame.record, image);
    if (trouble.empty() && has_ids) trouble = trouble_beside(path, image);
    frame.path = path;
    if (trouble.empty()) return "";
    troubles += (troubles.empty() ? "" : "\n") + trouble;
  }
  return troubles;
}

void BadFrames::add(std::uint32_t index, const std::string& trouble) {
  constexpr std::size_t kMost = 8;
  if (++count_ <= kMost) text_ += (count_ == 1 ? "" : "\n") + trouble;
  if (count_ == kMost + 1) text_ += "\nand more";
  bad_shards_.insert(index % shards_);
}

std::string BadFrames::describe() const { return text_ + how_to_make(bad_shards_, shards_, has_ids_); }

void gather(const Collection& collection, const std::filesystem::path& folder, bool overwrite) {
  SequenceFolder target(folder, collection.manifest.name);
  target.check_free(overwrite);
  target.make();
  const FolderLock lock(folder);
  target.build_apart();
  target.make();
  try {
    put_frames(collection, target.path());
    Manifest whole = collection.manifest;
    whole.shard = {};
    target.finish(std::move(whole));
  } catch (...) {
    target.give_up();
    throw;
  }
}

}  // namespace kerf

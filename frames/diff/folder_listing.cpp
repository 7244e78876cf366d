#include "frames/diff/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "frames/sequence/manifest.h"
#include "frames/sequence/sidecar.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

bool is_png(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".png" && !path.filename().string().starts_with(".");
}

/// "a.ids.png" and "a.draw.json" of "a.png".
bool is_beside_a_frame(const fs::path& path) {
  std::string frame = path.string();
  for (const std::string ending : {".ids.png", ".draw.json"}) {
    if (!frame.ends_with(ending)) continue;
    frame.replace(frame.size() - ending.size(), ending.size(), ".png");
    return fs::exists(frame) && fs::exists(ids_path(frame)) && fs::exists(draw_list_path(frame));
  }
  return false;
}

void take(const fs::path& path, const std::string& name, FolderListing& listing) {
  if (path.filename() == kManifestName) {
    listing.manifests.emplace(name, path);
  } else if (is_beside_a_frame(path)) {
    listing.beside.emplace(name, path);
  } else {
    (is_png(path) ? listing.frames : listing.others).emplace(name, path);
  }
}

void sort_in(const fs::directory_entry& entry, const std::string& name, FolderListing& listing) {
  std::error_code error;
  const fs::file_status status = entry.status(error);
  const auto refuse = [&](const char* why) { listing.faults.push_back(entry.path().string() + why); };
  if (status.type() == fs::file_type::not_found) {
    refuse(" is a link that leads nowhere");
  } else if (error) {
    refuse((": " + error.message()).c_str());
  } else if (fs::is_directory(status)) {
    if (entry.is_symlink()) {
      refuse(" is a link to a folder, which is not followed");
    } else if (fs::is_empty(entry.path())) {
      listing.others.emplace(name + "/", entry.path());
    }
  } else if (fs::is_regular_file(status)) {
    take(entry.path(), name, listing);
  } else {
    refuse(" is neither a file nor a folder");
  }
}

bool have_same_bytes(const fs::path& a, const fs::path& b) {
  if (fs::is_directory(a) || fs::is_directory(b)) return fs::is_directory(a) && fs::is_directory(b);
  std::ifstream first(a, std::ios::binary);
  std::ifstream second(b, std::ios::binary);
  const std::istreambuf_iterator<char> end;
  return first && second &&
         std::equal(std::istreambuf_iterator<char>(first), end, std::istreambuf_iterator<char>(second), end);
}

/// Takes the file out of the list, if it is there.
FilesByName one_of(FilesByName& files, const std::string& name) {
  FilesByName taken;
  taken.insert(files.extract(name));
  return taken;
}

/// Takes those that lie beside frames in the other folder out of the frames and other files.
void take_beside(FolderListing& listing, const FilesByName& beside_in_other) {
  for (const auto& [name, path] : beside_in_other) {
    listing.beside.merge(one_of(listing.frames, name));
    listing.beside.merge(one_of(listing.others, name));
  }
}

}  // namespace

FolderListing list_folder(const fs::path& folder) {
  FolderListing listing;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    sort_in(*entry, entry->path().lexically_relative(folder).generic_string(), listing);
  if (error) throw std::runtime_error("cannot compare " + folder.string() + ": " + error.message());
  std::ranges::sort(listing.faults);
  return listing;
}

void agree_on_beside(FolderListing& a, FolderListing& b) {
  const FilesByName beside_in_a = a.beside;
  take_beside(a, b.beside);
  take_beside(b, beside_in_a);
}

std::vector<std::string> compare_others(const FilesByName& reference, const FilesByName& test) {
  std::vector<std::string> faults;
  const auto refuse = [&faults](const fs::path& path, const char* why) {
    const bool is_hidden = path.filename().string().starts_with(".");
    const char* const what = fs::is_directory(path) ? " is an empty folder"
                             : is_hidden            ? " is a hidden file"
                                                    : " is no PNG";
    faults.push_back(path.string() + what + why);
  };
  for (const auto& [name, path] : reference) {
    const auto partner = test.find(name);
    if (partner == test.end()) {
      refuse(path, " and has no partner");
    } else if (!have_same_bytes(path, partner->second)) {
      refuse(path, ", and its bytes are not those of its partner");
    }
  }
  for (const auto& [name, path] : test)
    if (!reference.contains(name)) refuse(path, " and has no partner");
  return faults;
}

}  // namespace kerf

#include "frames/report/cell_store.h"

#include <algorithm>
#include <utility>

#include "core/files/whole_file.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/machine.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

/// The owner of the figures: this processor and this very program.
std::string owner() {
  const auto built = std::filesystem::last_write_time("/proc/self/exe").time_since_epoch().count();
  return describe_machine().value("processor", "") + ", kerf " + version() + ", " + std::to_string(built);
}

/// Whether `put` has written it, on any machine.
bool is_ours(const Json& json) {
  return json.is_object() && json.size() == 2 && json.contains("owner") && json["owner"].is_string() &&
         json.contains("cells") && json["cells"].is_object();
}

/// What a file of shards begins with: "page.shard-".
std::string shard_prefix(const std::filesystem::path& file) { return file.stem().string() + ".shard-"; }

std::filesystem::path shard_file(const std::filesystem::path& file, const Shard& shard) {
  return file.parent_path() / (shard_prefix(file) + std::to_string(shard.index + 1) + "-of-" +
                               std::to_string(shard.count) + ".json");
}

std::vector<std::filesystem::path> shard_files(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  std::vector<std::filesystem::path> found;
  if (!std::filesystem::is_directory(folder)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path name = entry.path().filename();
    if (name.string().starts_with(shard_prefix(file)) && name.extension() == ".json")
      found.push_back(file.parent_path() / name);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

CellStore::CellStore(const std::filesystem::path& file, const Shard& shard, bool forget)
    : file_(shard.count == 1 ? file : shard_file(file, shard)), shards_(shard_files(file)) {
  std::erase(shards_, file_);
  for (const std::filesystem::path& other : shards_) read(other, forget);
  if (shard.count > 1) read(file, forget);
  read(file_, forget);
}

void CellStore::put(const std::string& key, Json result) {
  results_[key] = std::move(result);
  write();
}

void CellStore::join() {
  if (shards_.empty()) return;
  write();
  for (const std::filesystem::path& shard : shards_) std::filesystem::remove(shard);
  shards_.clear();
}

void CellStore::read(const std::filesystem::path& file, bool forget) {
  const auto text = read_whole_file_if_there(file);
  if (!text) return;
  const Json kept = Json::parse(*text, nullptr, false);
  if (!is_ours(kept))
    throw UsageError(file.string() +
                     " would keep the figures, and holds something else; choose another name with --out, or "
                     "move that file away");
  if (kept["owner"] == owner()) {
    results_.update(kept["cells"]);
  } else if (!forget) {
    throw UsageError(file.string() +
                     " holds figures of another machine or another build of kerf; choose another name with "
                     "--out, or measure anew with --overwrite");
  }
}

void CellStore::write() const {
  constexpr int kIndent = 1;
  write_file_atomically(file_, Json{{"owner", owner()}, {"cells", results_}}.dump(kIndent) + "\n");
}

}  // namespace kerf

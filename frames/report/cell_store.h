#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/support/shard.h"

namespace kerf {

/// The results of cells in a JSON file, written after each. A shard has a file of its own beside it,
/// "page.shard-3-of-8.json" beside "page.json", and reads all of them. Results of another machine or version
/// are ignored.
class CellStore {
 public:
  /// Reads the files that are there. Throws UsageError if one is another program's, which `put` would
  /// destroy, or if it has figures of another machine or version and `forget` does not say that they may go.
  CellStore(const std::filesystem::path& file, const Shard& shard, bool forget);

  [[nodiscard]] bool has(const std::string& key) const { return results_.contains(key); }
  /// The key must exist.
  [[nodiscard]] const Json& at(const std::string& key) const { return results_.at(key); }
  /// Throws std::runtime_error if the file cannot be written.
  void put(const std::string& key, Json result);
  /// Forgets everything.
  void clear() { results_ = Json::object(); }
  /// Puts what the shards have left into the file itself, and removes theirs. Throws as `put` does.
  void join();
  /// Where `put` writes.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  void read(const std::filesystem::path& file, bool forget);
  void write() const;

  std::filesystem::path file_;
  std::vector<std::filesystem::path> shards_;  ///< the files of others
  Json results_ = Json::object();
};

}  // namespace kerf

#pragma once

#include <filesystem>
#include <string>

#include "frames/page/cell.h"

namespace kerf {

/// The results of cells in a JSON file, written after each. Results of another machine or version are
/// ignored.
class CellStore {
 public:
  /// Reads the file if there is one. Throws UsageError if it is another program's, which `put` would destroy,
  /// or if it has figures of another machine or version and `forget` does not say that they may go.
  CellStore(std::filesystem::path file, bool forget);

  [[nodiscard]] bool has(const std::string& key) const { return results_.contains(key); }
  /// The key must exist.
  [[nodiscard]] const Json& at(const std::string& key) const { return results_.at(key); }
  /// Throws std::runtime_error if the file cannot be written.
  void put(const std::string& key, Json result);
  /// Forgets everything.
  void clear() { results_ = Json::object(); }

 private:
  std::filesystem::path file_;
  Json results_ = Json::object();
};

}  // namespace kerf

#pragma once

#include <filesystem>
#include <vector>

namespace kerf {

/// The files of a database that is being made: unless it is kept they go away with this object, and an empty
/// file that had its name is empty again.
class FreshFiles {
 public:
  /// Pre: the file is not there, or empty. What is there is not ours to remove.
  explicit FreshFiles(std::filesystem::path database);
  ~FreshFiles();
  FreshFiles(const FreshFiles&) = delete;
  FreshFiles& operator=(const FreshFiles&) = delete;

  void keep() { is_kept_ = true; }

 private:
  std::filesystem::path database_;
  std::vector<std::filesystem::path> ours_;
  bool is_kept_ = false;
};

}  // namespace kerf

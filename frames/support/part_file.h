#pragma once

#include <filesystem>
#include <fstream>

namespace kerf {

/// A file that is written bit by bit under a temporary name beside its final one. It goes away with the
/// object unless it was kept, so that its name appears only when it is complete.
class PartFile {
 public:
  /// Throws std::system_error with path and reason.
  explicit PartFile(std::filesystem::path final_path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }
  /// Throws std::system_error with path and reason if what was written last could not be.
  void check() const;
  /// Gives the file its final name, in place of an earlier one. Throws as `check` does.
  void keep();

 private:
  std::filesystem::path final_path_;
  std::filesystem::path part_;
  std::ofstream stream_;
};

}  // namespace kerf

#pragma once

#include <filesystem>
#include <fstream>

#include "core/files/part_file.h"

namespace kerf {

/// A file that is written bit by bit and has its name only when it is complete (PartFile).
class PartStream {
 public:
  /// Throws std::system_error with path and reason, as all of these do.
  PartStream(const std::filesystem::path& final_path, Replace replace);

  [[nodiscard]] std::ostream& stream() { return stream_; }
  /// Throws if what was written last could not be.
  void check() const;
  void keep();

 private:
  PartFile part_;
  std::ofstream stream_;
};

}  // namespace kerf

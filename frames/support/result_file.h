#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include "core/files/part_file.h"

namespace kerf {

/// A file of results that is written anew whenever more of them are there. It has a part's name until all are
/// (PartFile), so that an earlier file stays until then; what a killed run has saved is in the part.
class ResultFile {
 public:
  /// An empty path is no file, and nothing is written. Throws std::system_error if the file could not be
  /// written, as all of these do.
  ResultFile(const std::filesystem::path& path, Replace replace);

  /// What there is so far. `complete`: that is all, and the file gets its name.
  void save(std::string_view text, bool complete);
  /// Of a run that ends early: what was saved gets the name if that is free. Says where it is, in a sentence
  /// that follows "interrupted".
  std::string end_early();

 private:
  std::unique_ptr<PartFile> part_;  ///< null: no file
  bool is_saved_ = false;
};

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

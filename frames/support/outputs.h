#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/part_file.h"

namespace kerf {

/// The door through which all outputs of a command go: each is held against what the command reads, what else
/// it writes and what is there already, before the command begins its work. A PartFile then builds it.
class Outputs {
 public:
  /// `inputs` are the files and folders that the command reads; empty ones are none. `if_there`: what is said
  /// of an output that is there, behind its name.
  Outputs(std::vector<std::filesystem::path> inputs, bool overwrite,
          std::string if_there = " exists already; choose another name, or replace it with --overwrite");

  /// Each throws UsageError, which says what to do, if the output is one of the inputs or lies in one, by
  /// whatever name; if it is another output, a folder, a device or a link to nothing; if it is there and
  /// `overwrite` is not given; or if what is there is a recording and the output is none, or the reverse. An
  /// empty path is no output.
  void add_file(const std::filesystem::path& out);
  void add_recording(const std::filesystem::path& out);
  /// A file that the command reads and brings up to date, which needs no `overwrite`: whether what is there
  /// is of its kind, the caller has checked.
  void add_kept(const std::filesystem::path& out);
  /// Throws UsageError if the folder is no folder, or is or holds one of the inputs. What a command replaces
  /// in it are outputs of their own.
  void add_folder(const std::filesystem::path& out);

  [[nodiscard]] Replace replace() const { return replace_if(overwrite_); }

 private:
  void check_apart_from_inputs(const std::filesystem::path& out) const;
  void check_apart_from_outputs(const std::filesystem::path& out);
  void check_free(const std::filesystem::path& out) const;

  std::vector<std::filesystem::path> inputs_;
  std::vector<std::filesystem::path> outputs_;  ///< resolved
  bool overwrite_;
  std::string if_there_;
};

}  // namespace kerf

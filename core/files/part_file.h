#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace kerf {

/// Whether a new file may take the place of an earlier one.
enum class Replace { nothing, earlier };
constexpr Replace replace_if(bool earlier) { return earlier ? Replace::earlier : Replace::nothing; }

/// Whether a new file is on the disk before it gets its name. A program that makes many small files that
/// can be made again may skip that and call `sync_file_system` once.
enum class Sync { now, later };

/// A file that is built beside the one that it will be, under a fresh name ("a.kerf.1b2c...part"), and gets
/// its final name by one rename when it is complete. Until then an earlier file of that name is untouched;
/// without `keep` or `leave` the part goes away with the object, and so does what SQLite has put beside it.
///
/// Where the final name is a link to a file, that file is the final one. All errors are std::system_error
/// with the final path and the reason.
class PartFile {
 public:
  explicit PartFile(const std::filesystem::path& final_path, Replace replace = Replace::earlier);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Where it is built. The file is there and empty.
  [[nodiscard]] const std::filesystem::path& path() const { return part_; }
  [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }

  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  /// Gives the file its name. If another file has come by that name meanwhile, which may not be replaced, the
  /// part stays where it is and the error says so.
  ///
  /// Pre: whatever else wrote to the part has closed it.
  void keep(Sync sync = Sync::now);
  /// Leaves the part under its own name.
  void leave() { is_left_ = true; }
  [[nodiscard]] bool is_left() const { return is_left_; }

 private:
  void take_name();

  std::filesystem::path final_;
  std::filesystem::path part_;
  Replace replace_;
  int file_ = -1;
  bool is_left_ = false;
};

/// A fresh name for what is to become `final_path`, in the same folder; nothing has it.
std::filesystem::path fresh_part_name(const std::filesystem::path& final_path);

/// Whether a file of this name is a part, of whatever final file.
bool is_part_name(std::string_view name);

/// What is being built, or was left by a process that was killed, for that final path.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& final_path);

/// Brings to the disk what was renamed within a folder.
void sync_folder(const std::filesystem::path& folder);
/// Brings to the disk all files of the file system in which `folder` lies.
void sync_file_system(const std::filesystem::path& folder);

/// Throws the std::system_error that says so; `error` is what errno was.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

}  // namespace kerf

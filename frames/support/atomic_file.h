#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/files/part_file.h"

namespace kerf {

/// Writes a file as PartFile does: its name appears only when it is complete. Throws std::system_error with
/// path and reason (disk full, no permission); then nothing is left behind and a file that had the name
/// before is untouched.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                           Replace replace = Replace::earlier);
void write_file_atomically(const std::filesystem::path& path, std::string_view text,
                           Replace replace = Replace::earlier);

/// Writes a copy of `from` in the same way. Throws std::runtime_error also if `from` cannot be read.
void copy_file_atomically(const std::filesystem::path& from, const std::filesystem::path& to);

/// Creates `folder` with its parents and proves by a trial file that it can be written.
/// Throws std::runtime_error with path, reason and the option by which another is chosen.
void make_writable_folder(const std::filesystem::path& folder, const std::string& option = "--out");

/// The message; of a full disk, which several rooms report in the system's words, also what to do, once.
std::string with_disk_advice(std::string message);

}  // namespace kerf

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf {

/// The byte order mark of UTF-8, with which some editors begin a file. It is no part of the text.
inline constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Throws UsageError, naming what the file `name` is, if it begins like UTF-16 or something else that is not
/// a text of bytes.
void check_is_text(const std::string& name, std::string_view begin);

/// The text of a whole file that a user wrote, 64 MB at most, without the mark of UTF-8. Throws UsageError,
/// naming the file, if it cannot be read or is no text.
std::string read_text_file(const std::filesystem::path& file);

}  // namespace kerf

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace kerf {

inline constexpr std::size_t kMostOfWholeFile = std::size_t{1} << 30U;

/// All bytes of a file, or of a pipe until its end. Throws std::runtime_error, with the path and the reason,
/// if it cannot be read, and if it has more than `most` bytes: a device may have no end.
std::string read_whole_file(const std::filesystem::path& file, std::size_t most = kMostOfWholeFile);
/// The same; nothing if nothing has that name.
std::optional<std::string> read_whole_file_if_there(const std::filesystem::path& file,
                                                    std::size_t most = kMostOfWholeFile);

}  // namespace kerf

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/recording/database.h"
#include "core/recording/recording_info.h"

namespace kerf {

/// SQLite's application id of recordings: "kerf" in ASCII.
inline constexpr std::uint32_t kRecordingId = 0x6B657266;
/// Raised when an older Kerf cannot read what a newer one writes (docs/RECORDING.md).
inline constexpr std::uint32_t kRecordingVersion = 7;
/// That of an import whose boxes were rounded as they were written: its verdicts may be `undecided`. It may
/// have a structure, too.
inline constexpr std::uint32_t kRoundedVersion = 9;

/// Makes the tables of a new recording and writes its info.
void create_schema(Database& database, const RecordingInfo& info);
/// Marks the recording as complete, and writes the end of its chain.
void set_complete(Database& database, std::uint64_t end);
/// The end of the chain of a complete recording; none if it is incomplete.
std::optional<std::uint64_t> read_end(const Database& database);

/// Folds the log that a killed writer has left beside a recording into it; the log of a recording that is
/// damaged beyond that goes. So nothing is left that SQLite would apply to another file of that name.
void fold_log(const std::filesystem::path& path);

/// Removes a recording with its log, whatever of it is there.
void remove_recording(const std::filesystem::path& path) noexcept;

/// Whether a file is a recording, of any version and state, and so may be replaced by another one.
bool is_recording(const std::filesystem::path& path);
/// Opens a recording, a part of it as `recording_at` says. Throws std::runtime_error, saying what to do, for
/// a file that is none or of another version.
Database open_recording(const std::filesystem::path& path);
/// Reads the info. Throws std::runtime_error if it makes no sense.
RecordingInfo read_info(const Database& database);

}  // namespace kerf

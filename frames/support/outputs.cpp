#include "frames/support/outputs.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "core/recording/schema.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

/// Whether `path` is `folder` or lies in it; both are resolved.
bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// As it is called without links, dots and a slash at the end, whether it is there or not.
fs::path resolved(const fs::path& file) {
  std::error_code none;  // a name may be too long to be resolved
  fs::path path = fs::weakly_canonical(fs::absolute(file), none);
  if (none) path = fs::absolute(file).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

/// By name, or as another name (a hard link) of the same file.
bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || resolved(a) == resolved(b);
}

/// Whether `out` is a folder's, be it there already or not.
bool lies_in(const fs::path& out, const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder, ignored) && is_within(resolved(out), resolved(folder));
}

/// By the first bytes, whatever the state of the rest. Of a recording that has just begun all may be in its
/// log.
bool looks_like_recording(const fs::path& file) {
  constexpr std::size_t kPlaceOfId = 68;
  std::array<char, kPlaceOfId + 4> head{};
  std::ifstream stream(file, std::ios::binary);
  std::error_code none;  // a name may be too long for a log
  if (!stream.read(head.data(), head.size()))
    return fs::is_empty(file) && fs::exists(file.string() + "-wal", none);
  std::uint32_t id = 0;
  for (std::size_t k = kPlaceOfId; k < head.size(); ++k) id = id << 8U | static_cast<std::uint8_t>(head[k]);
  return std::string_view(head.data()).starts_with("SQLite format 3") && id == kRecordingId;
}

void check_kind(const fs::path& out) {
  std::error_code ignored;
  if (fs::is_symlink(out, ignored) && !fs::exists(out, ignored))
    throw UsageError(out.string() + " is a link to nothing; choose another name");
  if (fs::is_directory(out)) throw UsageError(out.string() + " is a folder; choose the name of a file");
  if (fs::exists(out) && !fs::is_regular_file(out))
    throw UsageError(out.string() + " is no regular file and is not replaced; choose another name");
}

/// Who writes a dash means standard output.
void check_name(const fs::path& out) {
  if (out == "-") throw UsageError("'-' is no name of a file here; write ./- for a file of that name");
}

}  // namespace

Outputs::Outputs(std::vector<fs::path> inputs, bool overwrite, std::string if_there)
    : inputs_(std::move(inputs)), overwrite_(overwrite), if_there_(std::move(if_there)) {
  std::erase_if(inputs_, [](const fs::path& input) { return input.empty(); });
}

void Outputs::check_apart_from_inputs(const fs::path& out) const {
  for (const fs::path& input : inputs_) {
    if (is_same_file(out, input))
      throw UsageError(out.string() + " is the same file as " + input.string() +
                       ", which is read; choose another name");
    if (lies_in(out, input))
      throw UsageError(out.string() + " lies in " + input.string() + ", which is read; choose another place");
    if (is_same_file(out, input.string() + "-wal"))
      throw UsageError(out.string() + " belongs to " + input.string() +
                       ", which is read; choose another name");
  }
}

void Outputs::check_apart_from_outputs(const fs::path& out) {
  const fs::path place = resolved(out);
  if (std::ranges::find(outputs_, place) != outputs_.end())
    throw UsageError(out.string() + " would be written twice; give each output a name of its own");
  outputs_.push_back(place);
}

void Outputs::check_free(const fs::path& out) const {
  if (!overwrite_ && fs::exists(out)) throw UsageError(out.string() + if_there_);
}

void Outputs::add_file(const fs::path& out) {
  if (out.empty()) return;
  check_name(out);
  check_apart_from_inputs(out);
  check_apart_from_outputs(out);
  check_kind(out);
  if (fs::exists(out) && looks_like_recording(out))
    throw UsageError(out.string() +
                     " is a recording and is not replaced by another kind of file; choose another name");
  check_free(out);
}

void Outputs::add_recording(const fs::path& out) {
  if (out.empty()) return;
  check_name(out);
  check_apart_from_inputs(out);
  check_apart_from_outputs(out);
  check_kind(out);
  check_free(out);
  if (fs::exists(out) && !looks_like_recording(out))
    throw UsageError(out.string() + " is no recording and is not replaced; choose another name");
}

void Outputs::add_kept(const fs::path& out) {
  if (out.empty()) return;
  check_apart_from_inputs(out);
  check_apart_from_outputs(out);
  check_kind(out);
}

void Outputs::add_folder(const fs::path& out) {
  if (out.empty()) return;
  if (fs::exists(out) && !fs::is_directory(out))
    throw UsageError(out.string() + " is not a folder; choose another");
  for (const fs::path& input : inputs_)
    if (fs::is_directory(input) && is_within(resolved(input), resolved(out)))
      throw UsageError(out.string() + " is or holds " + input.string() +
                       ", which is read; choose a folder beside it");
}

}  // namespace kerf

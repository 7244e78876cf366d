#include "viz/debugger/session/session_keeper.h"

#include <exception>
#include <system_error>
#include <utility>

#include "core/files/part_file.h"
#include "core/files/whole_file.h"
#include "viz/debugger/session/session_text.h"

namespace kerf {
namespace {

std::string content_of(const std::filesystem::path& file) {
  try {
    return read_whole_file(file);
  } catch (const std::runtime_error& error) {
    throw SessionError(std::string("the session cannot be used: ") + error.what());
  }
}

DebuggerSession parse(const std::string& text, const std::filesystem::path& file) {
  try {
    return read_session(text);
  } catch (const SessionError& error) {
    throw SessionError(file.string() + " stays as it is: " + error.what());
  }
}

}  // namespace

std::filesystem::path session_path(const std::filesystem::path& recording) {
  return recording.string() + ".session";
}

DebuggerSession read_session_file(const std::filesystem::path& file) { return parse(content_of(file), file); }

std::optional<DebuggerSession> SessionKeeper::read() {
  std::error_code error;
  if (file_.empty() || !std::filesystem::exists(file_, error)) return std::nullopt;
  is_foreign_ = true;
  known_ = content_of(file_);
  DebuggerSession session = parse(known_, file_);
  is_foreign_ = false;
  return session;
}

void SessionKeeper::write(const std::string& text) {
  if (std::filesystem::exists(file_)) {
    const std::string there = content_of(file_);
    if (there != known_) {
      (void)parse(there, file_);
      std::filesystem::rename(file_, file_.string() + ".earlier");
    }
  }
  PartFile part(file_);
  part.write(text);
  part.keep();
  known_ = text;
}

std::string SessionKeeper::keep(const DebuggerSession& session) {
  if (file_.empty() || is_foreign_) return "";
  const std::string text = write_session(session);
  if (text == known_) return "";
  try {
    write(text);
    return "";
  } catch (const std::exception& error) {
    return std::exchange(has_said_, true) ? "" : std::string("the session is not saved: ") + error.what();
  }
}

}  // namespace kerf

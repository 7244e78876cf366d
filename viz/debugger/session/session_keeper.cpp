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

/// Nothing of the user's is in the earlier one alone.
bool may_replace(const std::filesystem::path& earlier, const DebuggerSession& session) {
  try {
    const DebuggerSession old = read_session_file(earlier);
    return !has_anything(old) || (old.recording == session.recording && holds(session, old));
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// The file itself, where it is a link.
std::filesystem::path behind_link(const std::filesystem::path& file) {
  return std::filesystem::is_symlink(file) ? std::filesystem::canonical(file) : file;
}

std::filesystem::path name_beside(const std::filesystem::path& file, const DebuggerSession& session) {
  const std::string first = file.string() + ".earlier";
  std::filesystem::path name = first;
  for (int k = 2; std::filesystem::exists(std::filesystem::symlink_status(name)); ++k) {
    if (may_replace(name, session)) break;
    name = first + "-" + std::to_string(k);
  }
  return name;
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

std::filesystem::path SessionKeeper::name_of_earlier() const {
  try {
    return name_beside(behind_link(file_), read_session_file(file_));
  } catch (const std::runtime_error&) {  // it has gone, or is no session any more
    return file_.string() + ".earlier";
  }
}

void SessionKeeper::write(const std::string& text) {
  const std::string there = std::filesystem::exists(file_) ? content_of(file_) : text;
  const std::filesystem::path file = std::filesystem::exists(file_) ? behind_link(file_) : file_;
  PartFile part(file);
  part.write(text);
  if (there != known_ && there != text) {
    const std::filesystem::path earlier = name_beside(file, parse(there, file_));
    std::filesystem::rename(file, earlier);
    note_ = "the earlier session is kept as " + earlier.string();
  }
  part.keep();
  known_ = text;
}

std::string SessionKeeper::save(const DebuggerSession& session) {
  if (file_.empty() || is_foreign_) return "";
  const std::string text = write_session(session);
  if (text == known_) return "";
  try {
    write(text);
    return "";
  } catch (const std::exception& error) {
    return std::string("the session is not saved: ") + error.what();
  }
}

std::string SessionKeeper::keep(const DebuggerSession& session) {
  const std::string problem = save(session);
  return problem.empty() || std::exchange(has_said_, true) ? "" : problem;
}

}  // namespace kerf

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "viz/debugger/session/session.h"

namespace kerf {

/// "pile.kerf.session"
std::filesystem::path session_path(const std::filesystem::path& recording);

/// Reads a session file. Throws SessionError, or std::system_error, with its path and the reason.
DebuggerSession read_session_file(const std::filesystem::path& file);

/// The file in which a session is kept. A file that is not what was read or written last is never replaced: a
/// session that came from elsewhere gets the name FILE.earlier, and anything else stays, and nothing is kept.
/// An earlier FILE.earlier is replaced only if the session has all of it; else the name is FILE.earlier-2,
/// and so on.
class SessionKeeper {
 public:
  /// Keeps nothing.
  SessionKeeper() = default;
  explicit SessionKeeper(std::filesystem::path file) : file_(std::move(file)) {}

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// What the file holds; none if there is no file. Throws as `read_session_file`: then the file stays as
  /// it is, and nothing is kept.
  std::optional<DebuggerSession> read();
  /// The earlier content is not gone on with, or not all of it: it gets another name before the next one is
  /// written.
  void begin_anew() { known_.clear(); }
  /// The name that the session that is there now would get.
  [[nodiscard]] std::filesystem::path name_of_earlier() const;
  /// Writes it if it differs from what is there. Returns why that cannot be done.
  std::string save(const DebuggerSession& session);
  /// The same, but says why only once.
  std::string keep(const DebuggerSession& session);
  /// Which name an earlier session got, in words, once for each.
  std::string take_note() { return std::exchange(note_, {}); }
  /// The file holds what is no session that can be read.
  [[nodiscard]] bool is_foreign() const { return is_foreign_; }

 private:
  void write(const std::string& text);

  std::filesystem::path file_;  ///< empty: keeps nothing
  std::string known_;           ///< its content as it was read or written last
  bool is_foreign_ = false;     ///< it holds what is no session that can be read
  bool has_said_ = false;       ///< why it cannot be written
  std::string note_;
};

}  // namespace kerf

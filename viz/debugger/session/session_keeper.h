#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "viz/debugger/session/session.h"

namespace kerf {

/// "pile.kerf.session"
std::filesystem::path session_path(const std::filesystem::path& recording);

/// Reads a session file. Throws SessionError, or std::system_error, with its path and the reason.
DebuggerSession read_session_file(const std::filesystem::path& file);

/// The file in which a session is kept. A file that is not what was read or written last is never replaced: a
/// session that came from elsewhere gets the name FILE.earlier, and anything else stays, and nothing is kept.
class SessionKeeper {
 public:
  /// Keeps nothing.
  SessionKeeper() = default;
  explicit SessionKeeper(std::filesystem::path file) : file_(std::move(file)) {}

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// What the file holds; none if there is no file. Throws as `read_session_file`: then the file stays as
  /// it is, and nothing is kept.
  std::optional<DebuggerSession> read();
  /// The earlier content is not gone on with: it gets another name before the next one is written.
  void begin_anew() { known_.clear(); }
  /// Writes it if it differs from what is there. Returns why that cannot be done, the first time.
  std::string keep(const DebuggerSession& session);

 private:
  void write(const std::string& text);

  std::filesystem::path file_;  ///< empty: keeps nothing
  std::string known_;           ///< its content as it was read or written last
  bool is_foreign_ = false;     ///< it holds what is no session that can be read
  bool has_said_ = false;       ///< why it cannot be written
};

}  // namespace kerf

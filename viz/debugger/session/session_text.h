#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "viz/debugger/session/session.h"

namespace kerf {

/// A text is no session that can be read; the message says why.
class SessionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A session as JSON, a line for each of its items.
std::string write_session(const DebuggerSession& session);
/// Reads it back. Throws SessionError: no session, one of a later version, or a damaged one.
DebuggerSession read_session(std::string_view text);

}  // namespace kerf

#pragma once

#include <stdexcept>
#include <string>

namespace kerf {

/// Throws std::runtime_error for a recording with content that no Kerf writes; `what` ends the sentence.
[[noreturn]] inline void fail_damaged(const std::string& what) {
  throw std::runtime_error("the recording is damaged: " + what);
}

}  // namespace kerf

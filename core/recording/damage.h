#pragma once

#include <stdexcept>
#include <string>

namespace kerf {

/// Throws std::runtime_error for a recording that holds what no Kerf has written; `what` ends the sentence.
[[noreturn]] inline void fail_damaged(const std::string& what) {
  throw std::runtime_error("the recording is damaged: " + what);
}

}  // namespace kerf

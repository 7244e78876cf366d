#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

namespace kerf {

/// A line on the terminal that is overwritten; silent if standard error is no terminal.
class ProgressLine {
 public:
  ProgressLine() = default;
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text) const {
    if (!shown_) return;
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
  }
  void clear() const { show(""); }
  [[nodiscard]] bool is_shown() const { return shown_; }

 private:
  bool shown_ = isatty(STDERR_FILENO) == 1;
};

}  // namespace kerf

#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

#include "frames/support/printed.h"
#include "frames/support/step_range.h"

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

/// The time that work has taken since this was made.
class Stint {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  /// "1:20 left", if the rest goes as what is done; empty before anything is done.
  [[nodiscard]] std::string left(double done, double all) const {
    if (!(done > 0)) return "";
    const int rest = static_cast<int>(seconds() * (all - done) / done);
    return printed("%d:%02d left", rest / 60, rest % 60);
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Counts measurements on the terminal: "12/200  about 1:20 left  falling-3d...".
class Countdown {
 public:
  /// `work` is the sum of what each is expected to take, in any unit.
  Countdown(std::size_t count, double work) : count_(count), all_(work) {}

  /// The next one begins.
  void begin(const std::string& name, double work) {
    const std::string left = stint_.left(done_, all_);
    line_.show(std::to_string(++begun_) + "/" + std::to_string(count_) + (left.empty() ? "" : "  about ") +
               left + "  " + name);
    done_ += work;
  }

 private:
  std::size_t count_;
  double all_;
  double done_ = 0;
  std::size_t begun_ = 0;
  ProgressLine line_;
  Stint stint_;
};

/// Such a line: frame, speed, time left.
class Progress {
 public:
  explicit Progress(const StepRange& steps);

  /// `frames` are done and the simulation is at `step`.
  void update(std::uint32_t frames, std::uint32_t step);

 private:
  using Clock = std::chrono::steady_clock;

  StepRange steps_;
  ProgressLine line_;
  Stint stint_;
  Clock::time_point last_{};
};

}  // namespace kerf

#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

#include "frames/support/progress_line.h"

namespace kerf {

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
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%d:%02d left", rest / 60, rest % 60);
    return text.data();
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

}  // namespace kerf

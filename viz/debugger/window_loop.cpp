#include "viz/debugger/window_loop.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr double kLongestWait = 0.2;  // seconds until the end of the program is noticed

}  // namespace

WindowLoop::WindowLoop(GlfwWindow& window, Debugger& debugger, std::optional<double> scale)
    : window_(window), debugger_(debugger), scale_(scale), last_(window.seconds()) {}

/// The effect of actions is shown once all of them are taken in: fast clicks do not wait for a frame each.
void WindowLoop::take_in() {
  debugger_.set_content_scale(scale_ ? *scale_ : window_.content_scale());
  do {
    debugger_.take_in(window_.take_input(), window_.width(), window_.height());
  } while (window_.has_input() && !debugger_.wants_screenshot() && window_.seconds() < last_ + kLongestWait);
}

bool WindowLoop::turn() {
  const auto until_due = [&](double now) {
    const double plays_on = last_ + debugger_.model().seconds_to_next() - now;
    return std::min(pace_.seconds_to_next(now), std::max(0.0, plays_on));
  };
  const bool user_acted = window_.wait(std::min(until_due(window_.seconds()), kLongestWait));
  const double now = window_.seconds();
  if (user_acted) pace_.user_acted(now);
  if (until_due(now) > 0) return false;
  last_ = now;
  take_in();
  if (const auto text = debugger_.take_copied()) window_.copy(*text);
  debugger_.draw();
  window_.set_pointer(debugger_.gui().pointer());
  present();
  pace_.drawn(now);
  return true;
}

void WindowLoop::present() {
  debugger_.show_in_window(window_.width(), window_.height());
  window_.swap();
}

}  // namespace kerf

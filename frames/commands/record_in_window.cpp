#include "frames/commands/record_in_window.h"

#include <string>

#include "frames/sequence/recording_file.h"
#include "frames/support/progress.h"
#include "viz/debugger/gui/progress_screen.h"

namespace kerf {
namespace {

constexpr double kBetweenPictures = 0.05;  // seconds

/// Draws the bar, and takes in what the user wants.
class Bar {
 public:
  Bar(GlfwWindow& window, std::string deed, std::uint32_t steps)
      : window_(window), screen_(window), deed_(std::move(deed)), steps_(steps) {
    draw(0);
  }

  RecordingWish turn(std::uint32_t step) {
    if (GlfwWindow::seconds() < drawn_ + kBetweenPictures) return RecordingWish::more;
    const bool is_enough = window_.wait(0) && window_.take_tap(Key::enter);
    if (!is_enough && (window_.take_tap(Key::escape) || window_.should_close())) return RecordingWish::none;
    draw(step);
    return is_enough ? RecordingWish::enough : RecordingWish::more;
  }

 private:
  void draw(std::uint32_t step) {
    const std::string left = stint_.left(step, steps_);
    screen_.draw({deed_, double{1} * step / steps_,
                  "step " + std::to_string(step) + " of " + std::to_string(steps_) +
                      (left.empty() ? "" : ", about " + left),
                  "Enter opens the steps so far, Escape leaves"},
                 window_.width(), window_.height());
    screen_.show_in_window(window_.width(), window_.height());
    window_.swap();
    drawn_ = GlfwWindow::seconds();
  }

  GlfwWindow& window_;
  ProgressScreen screen_;
  std::string deed_;
  std::uint32_t steps_;
  Stint stint_;
  double drawn_ = 0;
};

}  // namespace

std::filesystem::path record_in_window(const RenderRequest& request, CostOfRecording cost,
                                       GlfwWindow& window) {
  Bar bar(window, "recording " + recording_info(request).scene, request.steps.last);
  return record_scene(request, cost, [&](std::uint32_t step) { return bar.turn(step); });
}

void show_opening(const std::filesystem::path& file, GlfwWindow& window) {
  ProgressScreen screen(window);
  screen.draw({"opening " + file.filename().string(), {}, "", ""}, window.width(), window.height());
  screen.show_in_window(window.width(), window.height());
  window.swap();
}

}  // namespace kerf

#include "viz/debugger/model/view_history.h"

#include <utility>

namespace kerf {
namespace {

constexpr std::uint8_t kCamera = 1;
constexpr std::uint8_t kWindow = 2;
constexpr std::uint8_t kOthers = 4;

std::uint8_t parts_changed(const ViewState& a, const ViewState& b) {
  const bool others = a.settings != b.settings || a.selection != b.selection;
  return static_cast<std::uint8_t>((a.camera == b.camera ? 0 : kCamera) |
                                   (a.window == b.window ? 0 : kWindow) | (others ? kOthers : 0));
}

}  // namespace

void ViewHistory::see(const ViewState& now, const ViewFrame& frame) {
  since_ += frame.seconds;
  if (frame.held && !std::exchange(held_, frame.held)) is_of_drag_ = false;
  held_ = frame.held;
  if (!present_) present_ = now;
  if (frame.moved) present_->window = now.window;
  if (now == *present_) return;
  const std::uint8_t parts = parts_changed(now, *present_);
  const bool of_wheel = !frame.held && parts == parts_ && since_ <= kPause;
  if (!(frame.held && is_of_drag_) && !of_wheel) {
    undo_.push_back(*present_);
    if (undo_.size() > kMost) undo_.erase(undo_.begin());
  }
  redo_.clear();
  is_of_drag_ = frame.held;
  parts_ = frame.held || (parts & kOthers) != 0 ? 0 : parts;
  since_ = 0;
  present_ = now;
}

std::optional<ViewState> ViewHistory::take(std::vector<ViewState>& from, std::vector<ViewState>& to) {
  if (from.empty()) return std::nullopt;
  to.push_back(std::exchange(*present_, std::move(from.back())));
  from.pop_back();
  is_of_drag_ = false;
  parts_ = 0;
  return present_;
}

}  // namespace kerf

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "viz/debugger/model/selection.h"
#include "viz/debugger/model/time_window.h"
#include "viz/debugger/model/view_settings.h"

namespace kerf {

/// What the user sees of a run at any moment.
struct ViewState {
  ViewSettings settings;
  AnyCamera camera;
  TimeWindow window;  ///< of the lanes
  Selection selection;
  friend bool operator==(const ViewState&, const ViewState&) = default;
};

/// What else a frame says about a change of the view.
struct ViewFrame {
  bool held = false;   ///< a button of the mouse is down
  bool moved = false;  ///< the run has moved, and the lanes may have followed it
  double seconds = 0;  ///< since the last frame
};

/// The user's changes of the view, to be taken back and made again. One drag is one change, and so are turns
/// of the wheel that follow each other.
class ViewHistory {
 public:
  static constexpr double kPause = 0.5;      ///< seconds after which a turn of the wheel is a new change
  static constexpr std::size_t kMost = 200;  ///< earlier changes are forgotten

  /// Takes in what is seen in a frame.
  void see(const ViewState& now, const ViewFrame& frame);
  /// The view before the last change; none if there is none. The next frame must have it.
  std::optional<ViewState> undo() { return take(undo_, redo_); }
  /// The view after the change that was taken back last.
  std::optional<ViewState> redo() { return take(redo_, undo_); }
  [[nodiscard]] std::size_t changes() const { return undo_.size(); }
  [[nodiscard]] std::size_t taken_back() const { return redo_.size(); }

 private:
  std::optional<ViewState> take(std::vector<ViewState>& from, std::vector<ViewState>& to);

  std::optional<ViewState> present_;
  std::vector<ViewState> undo_;  ///< the last one at the end
  std::vector<ViewState> redo_;
  bool held_ = false;        ///< in the last frame
  bool is_of_drag_ = false;  ///< the last change was made with the button that is down
  std::uint8_t parts_ = 0;   ///< of the last change, if the wheel may go on with it
  double since_ = 0;         ///< the last change, in seconds
};

}  // namespace kerf

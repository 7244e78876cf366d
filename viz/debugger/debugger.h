#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viz/debugger/gui/gui.h"
#include "viz/debugger/model/debugger_model.h"
#include "viz/debugger/model/view_history.h"
#include "viz/debugger/panels/panel.h"
#include "viz/debugger/scene/scene_view.h"
#include "viz/debugger/session/recent_files.h"
#include "viz/debugger/session/session_keeper.h"
#include "viz/debugger/window/arrangement.h"
#include "viz/gl/context.h"
#include "viz/gl/framebuffer.h"
#include "viz/image/image.h"

namespace kerf {

inline constexpr int kLeastDebuggerWidth = 960;
inline constexpr int kLeastDebuggerHeight = 600;

/// The debugger: user input goes in, a picture comes out, one frame at a time. It does not depend on whether
/// a window or a script drives it, and draws the same in both.
class Debugger {
 public:
  /// The context must be current, and outlive it.
  Debugger(GlContext& context, std::unique_ptr<Run> run);

  /// Takes in the user's actions and draws a frame of that many pixels.
  void frame(const DebuggerInput& input, int width, int height);
  /// The first half of that, for input that comes faster than frames can be drawn.
  void take_in(const DebuggerInput& input, int width, int height);
  void draw();
  /// The next picture is drawn from nothing.
  void forget_picture() { is_new_ = true; }
  /// The last frame. Valid until the next call.
  const Image& picture();
  /// Shows the last frame in the window of the context.
  void show_in_window(int width, int height) const { framebuffer_->show_in_window(width, height); }

  /// The user asked for a picture.
  [[nodiscard]] bool wants_screenshot() const { return memory_.screenshot; }
  /// The same, once for each picture.
  bool takes_screenshot();
  /// Pixels in a unit of the panels, before the user's zoom: what the display asks for.
  void set_content_scale(double scale) { content_scale_ = scale; }
  /// The same with the zoom, as far as the window has room for it.
  [[nodiscard]] double scale() const { return gui_.scale(); }
  /// Layout, zoom and theme. They hold from the next frame on.
  [[nodiscard]] WindowSettings& window() { return memory_.window; }
  /// The user moves a panel or a divider at this moment.
  [[nodiscard]] bool is_dragging() const { return gui_.is_held(); }
  /// A text for the clipboard, once for each that the user has copied.
  std::optional<std::string> take_copied();
  /// Reports the result of a request, or why it failed.
  void report(std::string message, bool is_error);

  /// As a window opens: at a moment with a tree to look at, and with what is seen in words.
  void welcome();
  /// Begins the tour.
  void begin_tour() { memory_.tour = 0; }

  /// "pile - kerf debug pile.kerf"
  [[nodiscard]] std::string title() const;
  /// Goes to another recording; if it cannot be opened, says why, and returns false.
  bool open(const std::filesystem::path& file);
  /// Remembers the recordings that are opened in a file of that folder, and offers the latest in the search.
  void remember_in(const std::filesystem::path& folder);

  /// Keeps what the user does beside each recording from now on (not beside those in the model's work
  /// folder), and offers to go on where the last session was.
  void keep_sessions_beside();
  /// Goes on where a session file was, if it is there, and keeps it there. Several are joined, with the one
  /// beside the recording, which then is what is kept. Throws SessionError if one cannot be read.
  void go_on_with_files(const std::vector<std::filesystem::path>& files);
  /// Writes the session if it was changed. Says, and returns, once why that cannot be done.
  std::string keep_session();
  /// The same, now and then. In seconds of any clock.
  void keep_session_at(double now);
  /// Goes on where a file was. Throws SessionError if it cannot be read.
  void load_session(const std::filesystem::path& file);
  /// Writes a session to a file, which is new or one already. Returns why it cannot be written; throws
  /// SessionError if there is something else.
  std::string save_session(const std::filesystem::path& file);
  /// Calls `say` with the name that an earlier session got when a new one took its place.
  void on_earlier_session(std::function<void(const std::string&)> say) { say_earlier_ = std::move(say); }
  [[nodiscard]] const std::filesystem::path& session_file() const { return keeper_.file(); }

  [[nodiscard]] DebuggerModel& model() { return model_; }
  [[nodiscard]] const Gui& gui() const { return gui_; }
  [[nodiscard]] const SceneView& view() const { return *view_; }
  /// The values that a script can test, by name: "step", "selection", "state" and so on.
  [[nodiscard]] std::map<std::string, std::string> facts();

 private:
  void arrange_window();
  void press(const std::string& name);
  void begin_session();
  void go_on_with(const DebuggerSession& session);
  [[nodiscard]] DebuggerSession present_session();
  void spare(SessionKeeper& keeper, const DebuggerSession& kept);
  SessionKeeper& saver_of(const std::filesystem::path& file);
  void say_note(SessionKeeper& keeper);
  [[nodiscard]] bool is_scratch() const;
  void remember_recording();
  void answer_offer(bool goes_on);
  void take_back(int changes);
  void do_what_was_asked(const DebuggerInput& input);
  void see_view(const DebuggerInput& input);
  void take_any_key(const DebuggerInput& input);
  bool take_session_key(const DebuggerInput& input);
  void take_key(Key key, bool shift);
  bool take_control_key(Key key, bool shift);
  void ask_at_mouse();
  void take_time_key(Key key, bool shift);
  void take_tree_key(Key key, bool shift);
  void update_views();
  void draw_panels(PanelContext& context);
  void draw_view(PanelContext& context);
  [[nodiscard]] float pixels(float units) const;
  [[nodiscard]] PixelArea in_pixels(const PanelArea& area) const;
  [[nodiscard]] PixelArea part_to_draw();
  void point_at(PanelContext& context, double x, double y);
  void use_mouse(PanelContext& context, const PanelArea& area);

  GlContext& context_;
  DebuggerModel model_;
  Gui gui_;
  std::unique_ptr<SceneView> view_;
  std::unique_ptr<SceneView> other_view_;
  const Run* run_;              ///< the run of `view_`
  const Run* other_ = nullptr;  ///< the run of `other_view_`
  PanelMemory memory_;
  Arrangement arrangement_;  ///< of the last frame
  double content_scale_ = 1;
  std::optional<Framebuffer> framebuffer_;
  bool is_turning_ = false;                    ///< the mouse drags the scene
  std::optional<Eigen::Vector2d> over_scene_;  ///< the mouse, in pixels of the view
  bool is_new_ = true;                         ///< the framebuffer has no picture yet
  int panel_pictures_ = 0;                     ///< pictures for which not only the scene was drawn
  int width_ = 0;
  int height_ = 0;
  Image image_;
  double panel_seconds_ = 0;  ///< processor time of the panels in the last frame

  std::filesystem::path recording_;  ///< that was opened; the run may be another one after a change over
  bool keeps_beside_ = false;
  SessionKeeper keeper_;
  std::map<std::filesystem::path, SessionKeeper> savers_;  ///< of other files, by their full names
  std::function<void(const std::string&)> say_earlier_;
  std::optional<DebuggerSession> offered_;  ///< not answered yet
  std::optional<DebuggerSession> last_;     ///< of `recording_`
  double saved_at_ = 0;
  RecentFiles recent_;
  ViewHistory history_;
  const Run* history_of_ = nullptr;
  Position seen_at_;  ///< moment of the last frame
};

}  // namespace kerf

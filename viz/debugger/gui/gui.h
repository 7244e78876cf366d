#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "viz/debugger/gui/input.h"
#include "viz/debugger/gui/layout_beside.h"
#include "viz/debugger/gui/panel_area.h"
#include "viz/debugger/gui/panel_painter.h"
#include "viz/draw/theme.h"

struct ImGuiContext;

namespace kerf {

/// Dear ImGui with our typeface, colours and drawing. There is one at a time for each thread that draws.
class Gui {
 public:
  explicit Gui(const GlFunctions& gl);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// From the next frame on a unit of the panels is `scale` pixels, and letters are drawn at that size.
  void set_scale(double scale);
  void set_theme(const Theme& theme);
  [[nodiscard]] double scale() const { return scale_; }
  /// Begins a frame of that many pixels.
  void begin(const DebuggerInput& input, int width, int height);
  /// Ends the frame and lays it out; nothing is drawn yet.
  void end();
  /// Whether what is laid out beside the scene is as it was when this was asked before.
  bool is_same_beside(const PanelArea& scene);
  /// Draws the layout, or a part of it.
  void draw() const;
  void draw_within(const PixelArea& part) const;
  /// Whether a text field has the keys. True from the frame after it got them, and false from the frame after
  /// it gave them back: Dear ImGui itself reports it a frame late.
  [[nodiscard]] bool is_typing() const;
  /// The same, or a menu has them.
  [[nodiscard]] bool has_keys() const;
  /// What the last frame wants under the mouse.
  [[nodiscard]] Pointer pointer() const;
  /// A button of the mouse is down.
  [[nodiscard]] bool is_held() const { return is_held_; }

  /// Records the place of the last item under a name by which scripts find it, if it is visible. Its
  /// text, `shown`, is a second name unless another item has it.
  void name_last_item(const std::string& name, const std::string& shown = "");
  /// For an item that is only shown: scripts find it, but it is not among the names of what can be pressed.
  void note_last_item(const std::string& shown);
  void name_area(const std::string& name, const PanelArea& area) { named_[name] = area; }
  /// Of the last frame.
  [[nodiscard]] std::optional<PanelArea> find(const std::string& name) const;
  [[nodiscard]] const std::map<std::string, PanelArea>& named() const { return named_; }

 private:
  struct Forget {
    void operator()(ImGuiContext* context) const;
  };
  std::unique_ptr<ImGuiContext, Forget> context_;
  std::unique_ptr<PanelPainter> painter_;
  double scale_ = 1;
  bool is_held_ = false;
  PanelPicture picture_;  ///< of this frame
  LayoutBeside beside_;
  const Theme* theme_ = nullptr;
  std::map<std::string, PanelArea> named_;
  std::map<std::string, PanelArea> shown_;  ///< by text; the first of equal ones
};

}  // namespace kerf

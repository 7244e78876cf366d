#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "viz/debugger/gui/input.h"
#include "viz/debugger/gui/panel_painter.h"

struct ImGuiContext;

namespace kerf {

/// A rectangle of the picture in pixels, y down.
struct PanelArea {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;
};

/// Dear ImGui with our typeface, colours and drawing. There is one at a time for each thread that draws.
class Gui {
 public:
  explicit Gui(const GlFunctions& gl);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Begins a frame of that many pixels.
  void begin(const DebuggerInput& input, int width, int height);
  /// Ends the frame and lays it out; nothing is drawn yet.
  void end();
  void draw() const;
  /// Whether a text field has the keys. True from the frame after it got them, and false from the frame after
  /// it gave them back: Dear ImGui itself reports it a frame late.
  [[nodiscard]] bool is_typing() const;

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
  std::map<std::string, PanelArea> named_;
  std::map<std::string, PanelArea> shown_;  ///< by text; the first of equal ones
};

}  // namespace kerf

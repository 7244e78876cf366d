#pragma once

#include <imgui.h>

#include <string>

#include "viz/debugger/gui/gui.h"
#include "viz/draw/theme.h"

/// Parts of panels, each with a name by which scripts find it.
namespace kerf::widgets {

/// A button; `name` is its label unless given. `text` is its hint.
bool button(Gui& gui, const char* label, const char* text = "", const std::string& name = "");
/// A box with a mark; `name` and `text` as of a button.
bool checkbox(Gui& gui, const char* label, bool& value, const char* text = "", const std::string& name = "");
/// A field for one line of text; true when Enter is pressed. `inside` is shown while it is empty.
bool text_field(Gui& gui, const char* name, std::string& text, const char* inside, float width);
/// The ends of a slider; `logarithmic`: by the same factor for the same way, from a least above 0.
struct SliderRange {
  float least = 0;
  float most = 1;
  bool logarithmic = false;
};
/// A slider whose text (`format`, as of printf) is free of its grab: that is a bar at the lower edge.
bool slider(Gui& gui, const char* name, float& value, const SliderRange& range, const char* format,
            float width);
/// After a field: when the keys come to it, letters follow its text instead of replacing it.
void go_on_typing();
/// A row of a list that can be chosen; if it is cut, it ends with "..." and a hint has all of it.
bool row(Gui& gui, const std::string& label, const std::string& name, bool selected);
/// Places the next item beside the last one if there is room for so much, else below it.
void beside_or_below(float width);
/// Text in as many lines as needed, see `wrap_at_spaces`.
void wrapped_text(const std::string& text);
/// As much of a text as fits; if it is cut, it ends with "..." and a hint has all of it.
void text_within(Gui& gui, const std::string& text, Color color, float width);
/// The text, ending with "..." if it is wider than that.
std::string elided(const std::string& text, float width);
/// Shown when the mouse has rested on the last item for a while.
void hint(const char* text);
/// The line that marks an error of another engine in the scene, 16 pixels wide, from its left end.
void draw_error_sample(ImVec2 left, Color color);
/// The colours of the window.
const Theme& theme();
/// A line or an area in a colour of the palette, as the theme has it.
ImU32 to_imgui(Color color, double alpha = 1);
/// A text in a colour of the palette, as the theme has it.
ImU32 ink(Color color);
ImVec4 to_vector(Color color);
/// A colour that is the same in both themes.
ImU32 exactly(Color color, double alpha = 1);

}  // namespace kerf::widgets

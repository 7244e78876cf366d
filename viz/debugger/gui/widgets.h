#pragma once

#include <imgui.h>

#include <string>

#include "viz/debugger/gui/gui.h"
#include "viz/draw/color.h"

/// Parts of panels, each with a name by which scripts find it.
namespace kerf::widgets {

/// A button; `name` is its label unless given. `hint` is shown while the mouse is over it.
bool button(Gui& gui, const char* label, const char* hint = "", const std::string& name = "");
bool checkbox(Gui& gui, const char* label, bool& value, const char* hint = "");
/// A field for one line of text; true when Enter is pressed.
bool text_field(Gui& gui, const char* name, std::string& text, const char* hint, float width);
/// A row of a list that can be chosen.
bool row(Gui& gui, const std::string& label, const std::string& name, bool selected);
void hint(const char* text);
ImU32 to_imgui(Color color, double alpha = 1);
ImVec4 to_vector(Color color);

}  // namespace kerf::widgets

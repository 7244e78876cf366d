#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "viz/draw/color.h"

namespace kerf {

enum class ThemeName : std::uint8_t { light, dark };
inline constexpr std::array<std::string_view, 2> kThemeNames{"light", "dark"};

/// The colours of the debugger's window. The palette has the light ones: a theme says what stands for each of
/// them. Text has a contrast of at least 4.5 with every ground on which it stands, marks one of 3.
struct Theme {
  ThemeName name;
  Color scene;  ///< ground of the view
  Color panel;
  Color list;   ///< ground of lists within a panel
  Color paper;  ///< ground of the lanes
  Color popup;
  Color field;
  Color button;
  Color hovered;      ///< a button under the mouse,
  Color pressed;      ///< and when it is pressed
  Color selected;     ///< ground of a row that is selected,
  Color row_hovered;  ///< and of one under the mouse
  Color table_header;
  Color odd_row;  ///< of a table
  Color border;
  Color divider;  ///< that is dragged

  /// What stands for a colour of the palette in text; other colours stay.
  [[nodiscard]] Color text(Color palette_color) const;
  /// The same for lines and areas.
  [[nodiscard]] Color mark(Color palette_color) const;
};

const Theme& theme_called(ThemeName name);

}  // namespace kerf

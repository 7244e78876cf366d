#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viz/debugger/model/find_hits.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {

/// The room that the button of a panel's menu takes at the right.
inline constexpr float kMenuRoom = 18;

/// By which scripts and areas know a panel: "what if".
std::string panel_name(PanelId panel);

/// The menu at the title of a panel, if it has been opened.
void draw_panel_menu(PanelContext& context, PanelId panel);
/// The button for the menu of the window: panels, size of texts, theme.
void draw_window_menu(PanelContext& context);
/// What can be done with the window and the camera, as commands of which all words of a query are part.
std::vector<SearchHit> window_hits(PanelContext& context, std::string_view query);

}  // namespace kerf

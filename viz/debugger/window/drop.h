#pragma once

#include <optional>

#include "viz/debugger/window/arrangement.h"

namespace kerf {

/// What happens if a panel is dropped, and the area that it would get.
struct PanelDrop {
  DropTarget target;
  PanelArea area;
};
/// None where a drop changes nothing.
std::optional<PanelDrop> drop_at(const WindowLayout& layout, const Arrangement& arrangement, PanelId panel,
                                 float x, float y);

}  // namespace kerf

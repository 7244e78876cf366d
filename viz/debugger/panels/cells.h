#pragma once

#include "viz/debugger/panels/panel.h"
#include "viz/debugger/window/arrangement.h"

namespace kerf {

/// The panels that can be moved, each in its cell.
void draw_cells(PanelContext& context, const Arrangement& arrangement);
/// The lines between them, which can be dragged.
void draw_dividers(PanelContext& context, const Arrangement& arrangement);
/// Shows where a panel that is dragged would go, and puts it there when the mouse lets go.
void drag_panel(PanelContext& context, const Arrangement& arrangement);

}  // namespace kerf

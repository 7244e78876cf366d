#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/replay/position.h"

namespace kerf {

/// A panel to be copied.
struct CopyWish {
  std::string panel;  ///< its name, see copying.h; empty: the one under the mouse, or the last one used
  bool as_csv = false;
};

/// What panels and keys ask of the debugger, which does it in the next frame, and what it answers.
struct SessionMemory {
  std::string offer;                          ///< what a kept session has; empty: none is offered
  std::string offer_warning;                  ///< why it may not fit
  std::optional<bool> answer;                 ///< to the offer: go on there, or begin anew
  std::optional<std::filesystem::path> open;  ///< a recording to go to
  std::vector<std::string> recent;            ///< recordings that were opened lately, the latest first
  int changes_back = 0;                       ///< changes of the view to take back; below zero: to make again
  std::optional<Position> note_of;            ///< the bookmark whose note takes the keys in the next frame
  std::optional<CopyWish> copy;
  std::string used_panel;  ///< the name of the last one that was clicked
};

}  // namespace kerf

#pragma once

#include <string>
#include <vector>

#include "viz/debugger/model/find_hits.h"
#include "viz/debugger/panels/panel.h"

namespace kerf {

/// What a search finds beside `find_hits`: recordings to open, by their path or among the latest, changes of
/// the view to take back, and panels to copy.
std::vector<SearchHit> find_all_hits(const PanelContext& context, const std::string& query);

}  // namespace kerf

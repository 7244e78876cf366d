#pragma once

#include <memory>

#include "frames/rivals/query_rival.h"

namespace kerf {

std::unique_ptr<QueryRival<2>> make_box2d_queries();

}  // namespace kerf

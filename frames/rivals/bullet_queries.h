#pragma once

#include <memory>

#include "frames/rivals/query_rival.h"

namespace kerf {

std::unique_ptr<QueryRival<3>> make_bullet_queries();

}  // namespace kerf

#pragma once

#include <memory>

#include "frames/rivals/query_rival.h"

namespace kerf {

std::unique_ptr<QueryRival<3>> make_fcl_queries();

}  // namespace kerf

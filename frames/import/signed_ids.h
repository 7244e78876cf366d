#pragma once

#include <string>
#include <vector>

#include "core/base/given_id.h"

namespace kerf {

/// Throws UsageError if no object has the name, but one has the same bits read the other way, with a sign or
/// without one, of 32 or 64: a table of pairs written so would make each pair of that object missed and
/// extra. `objects`: sorted. The message begins with `table` and `line`.
void check_sign(const GivenId& id, const std::vector<GivenId>& objects, const std::string& table,
                std::size_t line);

}  // namespace kerf

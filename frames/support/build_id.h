#pragma once

#include <string>

namespace kerf {

/// 16 hexadecimal digits that tell this program from every other build: a hash of its file, the same for each
/// copy.
const std::string& build_id();

}  // namespace kerf

#pragma once

#include <string>

namespace kerf {

/// Identifies the build of this program: a hash of its file, 16 hexadecimal digits. Copies have the same one.
const std::string& build_id();

}  // namespace kerf

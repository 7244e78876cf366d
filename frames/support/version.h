#pragma once

#include <string>

namespace kerf {

/// Kerf's version: that of CMake's project(), for example "0.2.0".
const char* version();

/// Identifies the build of this program: a hash of its file, 16 hexadecimal digits. Copies have the same one.
const std::string& build_id();

}  // namespace kerf

#pragma once

namespace kerf {

/// Kerf's version: that of CMake's project(), for example "0.2.0".
const char* version();

}  // namespace kerf

#pragma once

#include <string>

namespace kerf {

/// The text with "_" for what is no UTF-8: names of files may have any bytes, JSON may not.
std::string valid_utf8(const std::string& text);

}  // namespace kerf

#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// The text in lines of at most so many letters, broken at spaces alone: never within "-16.3868", as Dear
/// ImGui does. Only a word that is longer than a line is cut. What follows in the next lines is indented as
/// their first one is.
std::string wrap_at_spaces(std::string_view text, std::size_t columns);

}  // namespace kerf

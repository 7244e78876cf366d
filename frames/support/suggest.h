#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf {

/// Edits (insert, delete, replace one character) that turn `a` into `b`, capitals not counted.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that a typist of `given` probably meant; empty if none is near.
std::string_view nearest_name(std::string_view given, std::span<const std::string> names);

/// "unknown KIND 'given'; did you mean 'x'? Choose from: a, b, c"
std::string unknown_name_message(std::string_view kind, std::string_view given,
                                 std::span<const std::string> names);

}  // namespace kerf

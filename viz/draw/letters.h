#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

/// The characters of UTF-8 text; bytes that are no UTF-8 become U+FFFD.
std::vector<char32_t> decode_utf8(std::string_view text);

/// How many there are: columns of a typeface of fixed pitch.
std::size_t count_letters(std::string_view text);

/// The first of them, each whole.
std::string_view first_letters(std::string_view text, std::size_t count);

/// The text if it has so many letters at most; else its beginning and "...", together so many.
std::string shortened(std::string_view text, std::size_t letters);

}  // namespace kerf

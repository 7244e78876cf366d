#include "viz/draw/letters.h"

#include <algorithm>
#include <cstdint>

namespace kerf {
namespace {

/// A character and the bytes that stand for it.
struct Letter {
  char32_t code;
  std::size_t bytes;
};

/// Of a text that is not empty.
Letter first_letter(std::string_view text) {
  constexpr char32_t kReplacement = 0xfffd;
  const auto lead = static_cast<std::uint8_t>(text[0]);
  const int more = lead < 0x80 ? 0 : lead >> 5U == 6 ? 1 : lead >> 4U == 14 ? 2 : lead >> 3U == 30 ? 3 : -1;
  if (more < 0) return {kReplacement, 1};
  char32_t code = more == 0 ? lead : lead & (0x3fU >> static_cast<unsigned>(more));
  std::size_t bytes = 1;
  int read = 0;
  for (; read < more && bytes < text.size() && (static_cast<std::uint8_t>(text[bytes]) & 0xc0U) == 0x80U;
       ++read)
    code = code << 6U | (static_cast<std::uint8_t>(text[bytes++]) & 0x3fU);
  return {read == more ? code : kReplacement, bytes};
}

}  // namespace

std::vector<char32_t> decode_utf8(std::string_view text) {
  std::vector<char32_t> result;
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    result.push_back(letter.code);
    text.remove_prefix(letter.bytes);
  }
  return result;
}

std::size_t count_letters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(first_letter(text).bytes);
  return count;
}

std::string_view first_letters(std::string_view text, std::size_t count) {
  std::size_t bytes = 0;
  for (std::size_t k = 0; k < count && bytes < text.size(); ++k)
    bytes += first_letter(text.substr(bytes)).bytes;
  return text.substr(0, bytes);
}

std::string shortened(std::string_view text, std::size_t letters) {
  constexpr std::string_view kMore = "...";
  if (first_letters(text, letters).size() == text.size()) return std::string(text);
  const std::size_t kept = letters - std::min(letters, kMore.size());
  return std::string(first_letters(text, kept)).append(kMore.substr(0, letters));
}

}  // namespace kerf

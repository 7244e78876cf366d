#include "frames/support/text_file.h"

#include <array>
#include <stdexcept>

#include "core/files/whole_file.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

using namespace std::string_view_literals;

/// How files begin that are no text of bytes; the longer beginning stands before the shorter.
struct Beginning {
  std::string_view bytes;
  std::string_view meaning;
};
constexpr std::array kBeginnings{
    Beginning{"\xFF\xFE\0\0"sv, "a text in UTF-32; save it as UTF-8"},
    Beginning{"\0\0\xFE\xFF"sv, "a text in UTF-32; save it as UTF-8"},
    Beginning{"\xFF\xFE"sv, "a text in UTF-16; save it as UTF-8 (iconv -f utf-16 -t utf-8)"},
    Beginning{"\xFE\xFF"sv, "a text in UTF-16; save it as UTF-8 (iconv -f utf-16 -t utf-8)"},
    Beginning{"\x1F\x8B"sv, "compressed by gzip; unpack it first"},
    Beginning{"PK\x03\x04"sv, "a zip archive or a spreadsheet; export it as CSV"},
    Beginning{"SQLite format 3\0"sv, "a database, perhaps a recording, and no table of text"},
};

constexpr std::size_t kMostText = std::size_t{1} << 26U;

}  // namespace

void check_is_text(const std::string& name, std::string_view begin) {
  for (const Beginning& known : kBeginnings)
    if (begin.starts_with(known.bytes)) throw UsageError(name + " is " + std::string(known.meaning));
  if (begin.find('\0') != std::string_view::npos)
    throw UsageError(name + " has bytes of value 0: it is a text in UTF-16 without its mark, or no text");
}

std::string read_text_file(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_whole_file(file, kMostText);
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
  check_is_text(file.string(), text);
  if (text.starts_with(kUtf8Mark)) text.erase(0, kUtf8Mark.size());
  return text;
}

}  // namespace kerf

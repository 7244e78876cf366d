#include "frames/support/text_source.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "frames/support/errors.h"

namespace kerf {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kBuffer = std::size_t{1} << 16U;
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

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

}  // namespace

TextSource::TextSource(const std::filesystem::path& path)
    : name_(path == "-" ? "standard input" : path.string()), buffer_(kBuffer) {
  const bool is_input = path == "-";
  file_ = File(is_input ? fdopen(dup(STDIN_FILENO), "rb") : std::fopen(path.c_str(), "rb"));
  if (!file_) fail();
  if (is_input || std::fseek(file_.get(), 0, SEEK_SET) != 0) keep_copy();
  rewind();
  const std::string_view begin(buffer_.data(), size_);
  for (const Beginning& known : kBeginnings)
    if (begin.starts_with(known.bytes)) throw UsageError(name_ + " is " + std::string(known.meaning));
  if (begin.find('\0') != std::string_view::npos)
    throw UsageError(name_ + " has bytes of value 0: it is a text in UTF-16 without its mark, or no text");
}

void TextSource::fail() const {
  throw std::runtime_error("cannot read " + name_ + ": " + std::strerror(errno));
}

/// A pipe is read to its end.
void TextSource::keep_copy() {
  File copy(std::tmpfile());
  if (!copy) fail();
  for (std::size_t size = 1; size > 0;) {
    size = std::fread(buffer_.data(), 1, buffer_.size(), file_.get());
    if (std::fwrite(buffer_.data(), 1, size, copy.get()) != size) fail();
  }
  if (std::ferror(file_.get()) != 0 || std::fflush(copy.get()) != 0) fail();
  file_ = std::move(copy);
}

void TextSource::rewind() {
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail();
  fill();
  if (std::string_view(buffer_.data(), size_).starts_with(kUtf8Mark)) at_ = kUtf8Mark.size();
}

void TextSource::fill() {
  at_ = 0;
  size_ = std::fread(buffer_.data(), 1, buffer_.size(), file_.get());
  if (std::ferror(file_.get()) != 0) fail();
}

}  // namespace kerf

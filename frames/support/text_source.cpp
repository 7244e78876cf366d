#include "frames/support/text_source.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "core/recording/chain.h"
#include "frames/support/text_file.h"

namespace kerf {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16U;

}  // namespace

TextSource::TextSource(const std::filesystem::path& path)
    : name_(path == "-" ? "standard input" : path.string()), buffer_(kBuffer) {
  const bool is_input = path == "-";
  file_ = File(is_input ? fdopen(dup(STDIN_FILENO), "rb") : std::fopen(path.c_str(), "rb"));
  if (!file_) fail();
  if (is_input || std::fseek(file_.get(), 0, SEEK_SET) != 0) keep_copy();
  rewind();
  check_is_text(name_, {buffer_.data(), size_});
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
  fingerprint_ = 0;
  fill();
  if (std::string_view(buffer_.data(), size_).starts_with(kUtf8Mark)) at_ = kUtf8Mark.size();
}

void TextSource::fill() {
  at_ = 0;
  size_ = std::fread(buffer_.data(), 1, buffer_.size(), file_.get());
  if (std::ferror(file_.get()) != 0) fail();
  if (size_ == 0) return;
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(buffer_.data());
  fingerprint_ = hash_bytes({bytes, size_}, fingerprint_);
}

}  // namespace kerf

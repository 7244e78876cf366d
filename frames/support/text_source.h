#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace kerf {

/// The characters of a text file, which may be read again from its beginning. "-" is standard input; that,
/// and whatever else can be read only once, is kept in a file without a name meanwhile. A byte order mark of
/// UTF-8 is passed over.
class TextSource {
 public:
  static constexpr int kEnd = -1;

  /// Throws std::runtime_error if it cannot be read, and UsageError, naming what it is, if it begins like
  /// UTF-16 or something else that is not a text of bytes.
  explicit TextSource(const std::filesystem::path& path);

  /// The next character, or kEnd; peek() leaves it there.
  int peek() {
    if (at_ == size_) fill();
    return at_ == size_ ? kEnd : static_cast<unsigned char>(buffer_[at_]);
  }
  int take() {
    const int next = peek();
    if (next != kEnd) ++at_;
    return next;
  }
  /// Goes back to the first character.
  void rewind();
  /// A hash of what was read from the file since it began, or since rewind(); at the end, of all of it.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }
  /// The path, or "standard input".
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  [[noreturn]] void fail() const;
  void keep_copy();
  void fill();

  std::string name_;
  File file_;
  std::vector<char> buffer_;
  std::size_t at_ = 0;
  std::size_t size_ = 0;
  std::uint64_t fingerprint_ = 0;
};

}  // namespace kerf

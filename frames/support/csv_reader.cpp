#include "frames/support/csv_reader.h"

#include "frames/support/errors.h"

namespace kerf {
namespace {

bool is_line_end(int c) { return c == '\n' || c == '\r' || c == TextSource::kEnd; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

bool CsvReader::next() {
  bool found = false;
  while (!found && source_.peek() != TextSource::kEnd) found = read_record();
  has_record_ |= found;
  return found;
}

void CsvReader::rewind() {
  source_.rewind();
  next_line_ = 1;
}

std::string_view CsvReader::field(std::size_t column) const {
  const std::size_t begin = column == 0 ? 0 : ends_[column - 1];
  return std::string_view(text_).substr(begin, ends_[column] - begin);
}

/// False if the line says nothing: spreadsheets end tables with lines of commas.
bool CsvReader::read_record() {
  line_ = next_line_;
  text_.clear();
  ends_.clear();
  (void)skip_blanks();
  if (source_.peek() == '#') {
    (void)source_.take();
    const bool is_color =
        takes_colors_ && !is_blank(static_cast<char>(source_.peek())) && !is_line_end(source_.peek());
    if (!is_color) {
      skip_comment();
      return false;
    }
    text_ = "#";
  }
  for (;;) {
    read_field();
    if (take_line_end()) return !text_.empty();
    (void)source_.take();  // the comma
  }
}

void CsvReader::read_field() {
  const std::size_t begin = text_.size();
  (void)skip_blanks();
  if (source_.peek() == '"') return read_quoted();
  while (source_.peek() != ',' && !is_line_end(source_.peek())) {
    if (source_.peek() == '"') reject("a quote stands in the middle of a field; quote the whole field");
    if (source_.peek() == 0) reject("it has a byte of value 0, so it is no text");
    text_ += static_cast<char>(source_.take());
  }
  while (text_.size() > begin && is_blank(text_.back())) text_.pop_back();
  ends_.push_back(text_.size());
}

/// Two quotes are one of the field; lines may end within.
void CsvReader::read_quoted() {
  (void)source_.take();
  for (;;) {
    const int c = source_.take();
    if (c == TextSource::kEnd) reject("a quote is never closed");
    if (c == '"' && source_.peek() != '"') break;
    if (c == '"') (void)source_.take();
    if (c == '\n' || (c == '\r' && source_.peek() != '\n')) ++next_line_;
    text_ += static_cast<char>(c);
  }
  ends_.push_back(text_.size());
  if (!skip_blanks()) reject("something stands between a closing quote and the next comma");
}

/// Whether a comma or the end of the line follows the blanks.
bool CsvReader::skip_blanks() {
  while (source_.peek() == ' ' || source_.peek() == '\t') (void)source_.take();
  return source_.peek() == ',' || is_line_end(source_.peek());
}

void CsvReader::skip_comment() {
  constexpr std::size_t kMost = 4096;
  constexpr std::size_t kMostComments = 64;
  std::string comment;
  while (!is_line_end(source_.peek())) {
    const auto c = static_cast<char>(source_.take());
    if (!has_record_ && comment.size() < kMost) comment += c;
  }
  if (comment.find(',') != std::string::npos) comments_.push_back({line_, std::move(comment)});
  if (comments_.size() > kMostComments) comments_.erase(comments_.begin());
  (void)take_line_end();
}

bool CsvReader::take_line_end() {
  if (!is_line_end(source_.peek())) return false;
  const int end = source_.take();
  if (end == '\r' && source_.peek() == '\n') (void)source_.take();
  is_cut_ = end == TextSource::kEnd;
  ++next_line_;
  return true;
}

void CsvReader::reject(std::size_t line, const std::string& what) const {
  throw UsageError(name() + ", line " + std::to_string(line) + ": " + what);
}

}  // namespace kerf

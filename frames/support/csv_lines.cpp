#include "frames/support/csv_lines.h"

#include <charconv>
#include <cstring>
#include <stdexcept>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace

CsvLines::CsvLines(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_) throw std::runtime_error("cannot read " + path.string() + ": " + std::strerror(errno));
}

bool CsvLines::next() {
  while (std::getline(file_, line_)) {
    ++number_;
    const std::string_view text = trimmed(line_);
    if (text.empty() || text.front() == '#') continue;
    cut();
    const bool is_heading =
        number_ == 1 && !fields_[0].empty() && std::isalpha(static_cast<unsigned char>(fields_[0][0])) != 0;
    if (!is_heading) return true;
  }
  if (file_.bad()) throw std::runtime_error("cannot read " + path_.string());
  return false;
}

void CsvLines::cut() {
  fields_.clear();
  std::string_view rest = line_;
  for (;;) {
    const std::size_t comma = rest.find(',');
    fields_.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
}

std::uint32_t CsvLines::whole(std::size_t column, std::uint32_t most) const {
  const auto number = parse_number<std::uint32_t>(fields_[column]);
  if (!number || *number > most)
    reject("'" + std::string(fields_[column]) + "' in column " + std::to_string(column + 1) +
           " is no whole number from 0 to " + std::to_string(most));
  return *number;
}

float CsvLines::real(std::size_t column) const {
  float value = 0;
  const std::string_view text = fields_[column];
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    reject("'" + std::string(text) + "' in column " + std::to_string(column + 1) +
           " is no number that a float can hold");
  return value;
}

void CsvLines::reject(const std::string& what) const {
  throw UsageError(path_.string() + ", line " + std::to_string(number_) + ": " + what);
}

}  // namespace kerf

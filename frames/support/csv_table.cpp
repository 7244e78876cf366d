#include "frames/support/csv_table.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "core/base/counted.h"
#include "core/base/poll.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (const auto byte = static_cast<unsigned char>(c); std::isalnum(byte) != 0)
      letters += static_cast<char>(std::tolower(byte));
  return letters;
}

struct Real {
  double value = 0;
  bool is_number = false;
  bool is_too_large = false;
};

/// from_chars says that a number is out of range, and not whether it is too large or too near to 0; strtod
/// does.
Real parse_real(std::string_view text) {
  text = without_plus(text);
  Real real;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), real.value);
  real.is_number = error != std::errc::invalid_argument && end == text.data() + text.size();
  real.value += 0.0;  // -0 is 0: a recording of doubles keeps no sign of a zero
  if (!real.is_number || error == std::errc{}) return real;
  real.is_too_large = std::abs(std::strtod(std::string(text).c_str(), nullptr)) > 1;
  real.value = std::copysign(std::numeric_limits<double>::denorm_min(), text.front() == '-' ? -1.0 : 1.0);
  return real;
}

std::string single_quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string columns_text(std::size_t count) { return counted(count, "column"); }

std::vector<std::string_view> names_in(std::string_view comment) {
  std::vector<std::string_view> names;
  for (;;) {
    const std::size_t end = std::min(comment.find(','), comment.size());
    const std::string_view name = comment.substr(0, end);
    names.push_back(name.substr(std::min(name.find_first_not_of(" \t"), name.size())));
    if (end == comment.size()) return names;
    comment.remove_prefix(end + 1);
  }
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& path, std::vector<CsvColumn> columns)
    : reader_(path), columns_(std::move(columns)), place_(columns_.size()) {
  const bool has_line = reader_.next();
  if (has_line) check_separator();
  has_heading_ = has_line && is_heading();
  if (has_heading_) {
    std::vector<std::string_view> names;
    for (std::size_t place = 0; place < reader_.columns(); ++place) names.push_back(reader_.field(place));
    read_heading(names, reader_.line());
    if (reader_.next()) first_width_ = reader_.columns();
  } else {
    if (has_line) first_width_ = reader_.columns();
    read_heading_of_comment();
  }
  rewind();
}

bool CsvTable::is_heading() const {
  for (std::size_t place = 0; place < reader_.columns(); ++place)
    if (parse_real(reader_.field(place)).is_number) return false;
  return true;
}

void CsvTable::check_separator() const {
  for (std::size_t place = 0; place < reader_.columns(); ++place) {
    const std::string_view field = reader_.field(place);
    const std::size_t at = field.find_first_of(reader_.columns() == 1 ? ";\t| " : ";\t|");
    if (at == std::string_view::npos) continue;
    const std::string separator = field[at] == '\t'  ? "tabs"
                                  : field[at] == ' ' ? "blanks"
                                                     : single_quoted(field.substr(at, 1));
    reject("its columns are separated by " + separator +
           "; they must be separated by commas, and numbers have a decimal point");
  }
}

void CsvTable::read_heading(const std::vector<std::string_view>& names, std::size_t line) {
  for (const std::string_view name : names) {
    const std::size_t place = order_.size();
    const std::size_t column = column_called(name, place, line);
    if (place_[column])
      reader_.reject(line, "column " + std::to_string(place + 1) + ", " + single_quoted(name) + ", is " +
                               columns_[column].name + ", as column " + std::to_string(*place_[column] + 1) +
                               " is");
    place_[column] = place;
    order_.push_back(column);
  }
  least_ = order_.size();
  if (columns_[order_.front()].is_color) reader_.take_colors();
}

/// The last comment that can be one counts; without any, the last that was meant as one is refused: what it
/// says is not what would be read.
void CsvTable::read_heading_of_comment() {
  const CsvComment* heading = nullptr;
  bool is_whole = false;
  for (const CsvComment& comment : reader_.comments()) {
    const std::vector<std::string_view> names = names_in(comment.text);
    std::size_t known = 0;
    std::set<std::size_t> columns;
    for (const std::string_view name : names)
      if (const auto column = find_column(name)) {
        ++known;
        columns.insert(*column);
      }
    const bool fits = names.size() == first_width_ || first_width_ == 0;
    const bool can_be = fits && columns.size() == names.size();
    const bool is_meant = 2 * known > names.size() || (names.size() == first_width_ && known > 1);
    if (!can_be && (is_whole || !is_meant)) continue;
    heading = &comment;
    is_whole = can_be;
  }
  if (!heading) return;
  read_heading(names_in(heading->text), heading->line);
  if (!is_whole)
    reader_.reject(heading->line, "the heading has " + columns_text(order_.size()) + ", the first line has " +
                                      std::to_string(first_width_));
  has_heading_ = is_heading_comment_ = true;
}

std::optional<std::size_t> CsvTable::find_column(std::string_view called) const {
  const std::string given = letters_of(called);
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const CsvColumn& known = columns_[column];
    if (letters_of(known.name) == given || std::ranges::count(known.aliases, given) > 0) return column;
  }
  return std::nullopt;
}

std::size_t CsvTable::column_called(std::string_view name, std::size_t place, std::size_t line) const {
  if (const auto column = find_column(name)) return *column;
  std::string known;
  for (const CsvColumn& column : columns_) known += (known.empty() ? "" : ", ") + column.name;
  const std::string what = name.empty()
                               ? "column " + std::to_string(place + 1) + " of the heading has no name"
                               : "column " + single_quoted(name) + " of the heading is not known";
  reader_.reject(line, what + "; known are " + known);
}

void CsvTable::set_order(const std::vector<std::size_t>& columns, std::size_t least) {
  order_ = columns;
  least_ = least;
  for (std::size_t place = 0; place < order_.size(); ++place) place_[order_[place]] = place;
}

std::string CsvTable::names() const {
  std::string names;
  const std::size_t count = has_heading_ ? order_.size() : std::min(order_.size(), first_width_);
  for (std::size_t place = 0; place < count; ++place)
    names += (names.empty() ? "" : ", ") + columns_[order_[place]].name;
  return names;
}

bool CsvTable::next() {
  poll();
  if (!reader_.next()) return false;
  check_width();
  return true;
}

void CsvTable::check_width() const {
  const std::size_t width = reader_.columns();
  if (order_.empty() || (width >= least_ && width <= order_.size())) return;
  reject((has_heading_ ? "the heading has " + columns_text(order_.size())
                       : "the first line has " + columns_text(first_width_)) +
         ", this line has " + std::to_string(width) +
         (width > order_.size() ? "; are there decimal commas? numbers have a decimal point" : ""));
}

void CsvTable::rewind() {
  reader_.rewind();
  if (has_heading_ && !is_heading_comment_) (void)reader_.next();
}

std::string_view CsvTable::text(std::size_t column) const {
  const auto place = place_[column];
  return place && *place < reader_.columns() ? reader_.field(*place) : std::string_view();
}

double CsvTable::real(std::size_t column) const {
  const Real real = parse_real(text(column));
  if (!real.is_number)
    reject(column, text(column).find(',') == std::string_view::npos
                       ? "is no number"
                       : "has a decimal comma; numbers have a decimal point");
  if (real.is_too_large) reject(column, "is too large for a double");
  return real.value;
}

GivenId CsvTable::id(std::size_t column) const {
  const auto id = parse_given_id(text(column));
  if (!id) reject(column, "is no whole number of 64 bits");
  return *id;
}

std::uint64_t CsvTable::bits(std::size_t column) const {
  const std::string_view given = text(column);
  if (given.starts_with("0x") || given.starts_with("0X")) {
    std::uint64_t bits = 0;
    const auto [end, error] = std::from_chars(given.data() + 2, given.data() + given.size(), bits, 16);
    if (error != std::errc{} || end != given.data() + given.size())
      reject(column, "is no hexadecimal number of 64 bits");
    return bits;
  }
  const GivenId number = id(column);
  return number.negative ? -number.magnitude : number.magnitude;
}

bool CsvTable::boolean(std::size_t column) const {
  const std::string word = letters_of(text(column));
  if (word == "true" || word == "yes" || text(column) == "1" || text(column) == "1.0") return true;
  if (word == "false" || word == "no" || text(column) == "0" || text(column) == "0.0") return false;
  reject(column, "is neither 0 or 1 nor true or false");
}

void CsvTable::reject(std::size_t column, const std::string& what) const {
  reject(single_quoted(text(column)) + " in column " + std::to_string(place_[column].value_or(0) + 1) + ", " +
         columns_[column].name + ", " + what);
}

}  // namespace kerf

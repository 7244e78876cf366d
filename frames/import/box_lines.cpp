#include "frames/import/box_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/given_names.h"
#include "frames/import/written_digits.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

// The columns in the order of `box_columns()`.
constexpr std::size_t kStep = 0;
constexpr std::size_t kObject = 1;
constexpr std::size_t kBounds = 2;
constexpr std::size_t kFixed = kBounds + 6;
constexpr std::size_t kCategory = kFixed + 1;
constexpr std::size_t kMask = kCategory + 1;
constexpr std::size_t kAngle = kMask + 1;
constexpr std::size_t kQuaternion = kAngle + 1;

constexpr double kFarFromOne = 0.01;  // of the square of a quaternion's length

constexpr std::size_t min_column(int axis) { return kBounds + 2 * static_cast<std::size_t>(axis); }
constexpr std::size_t max_column(int axis) { return min_column(axis) + 1; }

/// min_x is also xmin, lower_x, x_lo, aabb.min.x, lowerBound.x and so on.
CsvColumn bound_column(const std::string& side, const std::vector<std::string>& sides,
                       const std::string& axis) {
  CsvColumn column{side + "_" + axis, {}};
  for (const std::string prefix : {"", "aabb", "box", "bbox", "bounds"})
    for (const std::string& other : sides)
      for (const std::string& name : {other + axis, axis + other}) column.aliases.push_back(prefix + name);
  return column;
}

std::vector<CsvColumn> box_columns() {
  std::vector<CsvColumn> columns{
      step_column(),
      {"object",
       {"id", "objectid", "body", "bodyid", "proxy", "proxyid", "handle", "entity", "entityid", "uid"}}};
  for (CsvColumn& bound : bound_columns()) columns.push_back(std::move(bound));
  columns.push_back({"fixed", {"isfixed", "static", "isstatic", "immovable"}});
  columns.push_back({"category", {"categories", "categorybits", "collisioncategory", "filtercategory"}});
  columns.push_back({"mask", {"masks", "maskbits", "collisionmask", "filtermask", "collideswith"}});
  columns.push_back({"angle", {"rotation", "theta"}});
  for (const std::string part : {"w", "x", "y", "z"})
    columns.push_back({"q" + part, {"quat" + part, "orientation" + part, "rotation" + part}});
  return columns;
}

/// The same for texts of the same number, whatever zeros, point and exponent they have.
std::string plain_number(const std::string& text) {
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  long long exponent = 0;
  const std::size_t sign = text.substr(end, 2).ends_with('+') ? 2 : 1;
  if (end < text.size()) std::from_chars(text.data() + end + sign, text.data() + text.size(), exponent);
  std::string digits;
  bool has_point = false;
  for (const char c : text.substr(0, end)) {
    has_point |= c == '.';
    if (c < '0' || c > '9') continue;
    exponent -= has_point ? 1 : 0;
    if (c != '0' || !digits.empty()) digits += c;
  }
  for (; digits.ends_with('0'); digits.pop_back()) ++exponent;
  return digits.empty() ? "0" : (text.starts_with('-') ? "-" : "") + digits + "e" + std::to_string(exponent);
}

constexpr std::size_t kSeconds = 17;  // where a date has them

bool leaps(const GivenStep& step) { return step.is_date() && step.text.substr(kSeconds).starts_with("60"); }

/// In which dates of one time may differ: the fraction of a second, and whether it is a leap second.
std::string plain_seconds(const GivenStep& date) {
  return (leaps(date) ? "60" : "") + plain_number("0" + date.text.substr(kSeconds + 2));
}

BoxLine::Oddity oddity_of(const BoxLine& line, int dimension) {
  BoxLine::Oddity oddity = BoxLine::Oddity::none;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    if (std::isnan(line.min[axis]) || std::isnan(line.max[axis])) return BoxLine::Oddity::not_a_number;
    if (std::isinf(line.min[axis]) || std::isinf(line.max[axis])) oddity = BoxLine::Oddity::infinite;
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    if (line.min[axis] > line.max[axis]) return BoxLine::Oddity::inverted;
  return oddity;
}

}  // namespace

BoxLines::BoxLines(const std::filesystem::path& path) : table_(path, box_columns()) {
  if (table_.first_width() == 0) throw UsageError(table_.name() + " has no boxes");
  if (table_.has_heading()) {
    find_dimension();
  } else {
    set_order();
  }
}

void BoxLines::find_dimension() {
  dimension_ = table_.has(min_column(2)) || table_.has(max_column(2)) ? 3 : 2;
  std::string missing;
  const auto want = [&](std::size_t column) {
    if (!table_.has(column)) missing += (missing.empty() ? "" : ", ") + box_columns()[column].name;
  };
  for (std::size_t column = 0; column <= max_column(dimension_ - 1); ++column) want(column);
  if (!missing.empty())
    throw UsageError(table_.name() + ": the heading lacks " + missing + "; it has " + table_.names());
  check_turn_columns();
}

/// A rotation of the other dimension would be passed over.
void BoxLines::check_turn_columns() const {
  bool has_part = false;
  for (std::size_t k = 0; k < 4; ++k) has_part |= table_.has(kQuaternion + k);
  if (dimension_ == 2 && has_part)
    throw UsageError(table_.name() + ": boxes in 2D are turned by angle, in radians, not by qw,qx,qy,qz");
  if (dimension_ == 3 && table_.has(kAngle))
    throw UsageError(table_.name() + ": boxes in 3D are turned by qw,qx,qy,qz, not by an angle");
}

void BoxLines::set_order() {
  const std::size_t width = table_.first_width();
  if (width < 6 || width > 9) {
    (void)table_.next();
    table_.reject("a box has 6 columns in 2D and 8 in 3D, and perhaps one more, fixed; this line has " +
                  std::to_string(width) + ". Any others need a heading");
  }
  dimension_ = width < 8 ? 2 : 3;
  std::vector<std::size_t> order;
  for (std::size_t column = 0; column <= max_column(dimension_ - 1); ++column) order.push_back(column);
  order.push_back(kFixed);
  table_.set_order(order, order.size() - 1);
}

bool BoxLines::next() {
  if (table_.next()) return true;
  if (fingerprint_.value_or(table_.fingerprint()) != table_.fingerprint()) reject_change();
  fingerprint_ = table_.fingerprint();
  return false;
}

void BoxLines::reject_change() const {
  throw UsageError(table_.name() + " changed while it was read; import a copy of it");
}

GivenStep BoxLines::step() const { return read_step(table_, kStep); }

std::optional<GivenId> BoxLines::object() const {
  if (table_.is_blank(kObject)) return std::nullopt;
  return table_.id(kObject);
}

BoxLine BoxLines::read() const {
  BoxLine line;
  line.line = table_.line();
  const auto id = object();
  if (id) line.object = *id;
  if (!table_.is_blank(kFixed)) line.fixed = table_.boolean(kFixed);
  if (!table_.is_blank(kCategory)) line.category = table_.bits(kCategory);
  if (!table_.is_blank(kMask)) line.mask = table_.bits(kMask);
  line.turn = read_turn();
  read_bounds(line);
  if (!id && line.kind == BoxLine::Kind::box) table_.reject("the box has no object");
  if (!id) line.kind = BoxLine::Kind::nothing;
  return line;
}

std::optional<std::array<double, 4>> BoxLines::read_turn() const {
  if (dimension_ == 2) {
    if (table_.is_blank(kAngle)) return std::nullopt;
    const double angle = table_.real(kAngle);
    if (!std::isfinite(angle)) table_.reject(kAngle, "is no angle in radians");
    return std::array<double, 4>{angle, 0, 0, 0};
  }
  std::array<double, 4> parts{};
  std::size_t blank = 0;
  double square = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    blank += table_.is_blank(kQuaternion + k) ? 1U : 0U;
    if (!table_.is_blank(kQuaternion + k)) parts[k] = table_.real(kQuaternion + k);
    square += parts[k] * parts[k];
  }
  if (blank == parts.size()) return std::nullopt;
  if (blank > 0) table_.reject("a quaternion has four numbers, qw, qx, qy and qz");
  if (!std::isfinite(square) || std::abs(square - 1) > kFarFromOne)
    table_.reject("qw, qx, qy and qz are no rotation: their squares must add up to 1");
  for (double& part : parts) part /= std::sqrt(square);
  return parts;
}

void BoxLines::read_bounds(BoxLine& line) const {
  int blank = 0;
  const auto bound = [&](std::size_t column) {
    if (!table_.is_blank(column)) return table_.real(column);
    ++blank;
    return std::numeric_limits<double>::quiet_NaN();
  };
  for (int axis = 0; axis < dimension_; ++axis) {
    line.min[static_cast<std::size_t>(axis)] = bound(min_column(axis));
    line.max[static_cast<std::size_t>(axis)] = bound(max_column(axis));
  }
  if (blank == 2 * dimension_) {
    line.kind = BoxLine::Kind::removal;
  } else {
    line.oddity = blank > 0 ? BoxLine::Oddity::half_blank : oddity_of(line, dimension_);
  }
}

void BoxLines::note_digits(TableWriting& written) const {
  for (std::size_t column = kBounds; column <= max_column(dimension_ - 1); ++column)
    written.note(table_.text(column));
}

void BoxLines::note_remainders(Remainders& remainders) const {
  for (std::size_t column = kBounds; column <= max_column(dimension_ - 1); ++column)
    if (!table_.is_blank(column)) remainders.note(table_.real(column));
}

void BoxLines::note_writing(BoundWriting& writing) const {
  for (int axis = 0; axis < dimension_; ++axis)
    writing.note(axis, judged_bound(min_column(axis)), judged_bound(max_column(axis)));
}

/// Two numbers between doubles would be one, and a pair of boxes that are apart would be missed.
std::string_view BoxLines::judged_bound(std::size_t column) const {
  const std::string_view text = table_.text(column);
  const bool is_no_bound = text == "9223372036854775807" || text == "18446744073709551615";
  if (text.size() > 15 && !is_no_bound && !may_be_of_double(text, table_.real(column)))
    table_.reject(column,
                  "is no double, so that no pair can be judged by it; write 15 digits (%.15g), or whole "
                  "numbers below 2^53");
  return text;
}

std::string conflict_of(const GivenStep& a, const GivenStep& b) {
  if (a.is_date() != b.is_date())
    return "step " + a.text + " is " + (a.is_date() ? "a date" : "a number") + ", and step " + b.text +
           " is " + (b.is_date() ? "a date" : "a number");
  const auto plain = [](const GivenStep& step) {
    return step.is_date() ? plain_seconds(step) : plain_number(step.text);
  };
  if (a.time != b.time || a.text == b.text || plain(a) == plain(b)) return "";
  const std::string both = "steps " + a.text + " and " + b.text;
  if (leaps(a) != leaps(b)) return both + " are one time: a leap second is the second after it";
  return both + " are too near to each other: 64 bits of a number count";
}

std::vector<CsvColumn> bound_columns() {
  std::vector<CsvColumn> columns;
  for (const std::string axis : {"x", "y", "z"}) {
    columns.push_back(bound_column("min", {"min", "minimum", "lower", "low", "lo", "lowerbound"}, axis));
    columns.push_back(bound_column("max", {"max", "maximum", "upper", "high", "hi", "upperbound"}, axis));
  }
  return columns;
}

CsvColumn step_column() {
  return {"step",
          {"frame", "tick", "time", "timestamp", "t", "iteration", "stepindex", "frameindex", "framenumber"}};
}

GivenStep read_step(const CsvTable& table, std::size_t column) {
  if (table.is_blank(column)) table.reject("the step is blank");
  std::string text(table.text(column));
  const auto time = parse_step_time(text);
  if (!time) table.reject(column, "is neither a number nor a time");
  if (text.starts_with('+')) text.erase(0, 1);
  return {*time, std::move(text)};
}

}  // namespace kerf

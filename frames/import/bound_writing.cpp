#include "frames/import/bound_writing.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace kerf {
namespace {

constexpr std::size_t kLeastDigits = 6;  // that programs write: %g
constexpr std::size_t kLeastShort = 4;   // of which many numbers are needed: %.4g
constexpr std::size_t kWholeFloat = 9;   // digits with which floats are written whole
constexpr std::size_t kFew = 3;          // fewer numbers of so many digits may be written by hand
constexpr std::size_t kMany = 8;
constexpr std::size_t kDozens = 24;  // of short numbers, which may be a grid
constexpr std::size_t kLeastSuspected = 2;
constexpr std::size_t kLeastDecimals = 2;
constexpr double kSurprising = 4.6;      // one in a hundred
constexpr double kVerySurprising = 6.8;  // one in a thousand; three numbers of six digits
constexpr std::size_t kWholeDouble = 17;
constexpr std::size_t kLeastWhole = 15;  // digits that are all of some doubles
constexpr std::size_t kMostTried = 64;
constexpr double kManyNumbers =
    10;                         // that have one text; the shortest text of a number seldom leaves as many
constexpr double kHuge = 1e15;  // bounds from here on are no places

/// A number as it was written: mantissa / 10^decimals.
struct Decimal {
  std::uint64_t mantissa = 0;
  std::size_t digits = 0;  ///< without leading zeros; beyond 19 the mantissa lacks them
  std::int64_t decimals = 0;
  bool has_point = false;
  bool ends_in_zero = false;  ///< before an exponent
  bool has_exponent = false;
  bool has_plus = false;  ///< before its exponent, as programs write it
};

Decimal read_decimal(std::string_view text) {
  Decimal number;
  std::size_t at = std::min(text.find_first_not_of("+-"), text.size());
  for (; at < text.size() && (text[at] == '.' || (text[at] >= '0' && text[at] <= '9')); ++at) {
    if (text[at] == '.') {
      number.has_point = true;
      continue;
    }
    number.decimals += number.has_point ? 1 : 0;
    number.ends_in_zero = text[at] == '0';
    if (number.digits == 0 && text[at] == '0') continue;
    if (++number.digits <= 19)
      number.mantissa = 10 * number.mantissa + static_cast<std::uint64_t>(text[at] - '0');
  }
  if (at == text.size()) return number;
  number.has_exponent = true;
  number.has_plus = text.substr(at + 1).starts_with('+');
  text.remove_prefix(std::min(at + (number.has_plus ? 2 : 1), text.size()));
  std::int64_t exponent = 0;
  std::from_chars(text.data(), text.data() + text.size(), exponent);
  number.decimals -= std::clamp<std::int64_t>(exponent, -400, 400);
  return number;
}

/// False of 1e+06, as %g writes a number of which it has no room for the last digits.
bool has_room(const Decimal& number) { return !number.has_plus || number.decimals >= 0; }

/// Whether the text is a whole number over a power of two, which needs no rounding. Where whole numbers have
/// an exponent, there was no room for more digits.
bool is_binary_fraction(Decimal number) {
  if (number.has_exponent && number.digits >= kLeastDigits) return false;
  if (number.digits > 19) return false;
  for (; number.decimals > 0 && number.mantissa != 0; --number.decimals) {
    if (number.mantissa % 5 != 0) return false;
    number.mantissa /= 5;
  }
  return true;
}

std::optional<double> parse(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// How far apart the numbers of a kind are there.
template <class Number>
double spacing_at(double value) {
  constexpr double kMost = std::numeric_limits<Number>::max();
  const auto nearest = static_cast<Number>(std::min(std::abs(value), kMost));
  return static_cast<double>(std::nextafter(nearest, std::numeric_limits<Number>::infinity()) - nearest);
}

bool keep_once(std::vector<double>& values, double value, std::size_t most) {
  if (values.size() >= most || std::ranges::find(values, value) != values.end()) return false;
  values.push_back(value);
  return true;
}

}  // namespace

void DigitStatistics::Seen::note(double value) {
  ++count;
  (void)keep_once(some, value, kDozens);
}

/// Of numbers that are no further apart than a unit of the text one has it.
void DigitStatistics::Short::note(double value, double unit, double spacing) {
  if (unit > spacing && keep_once(some, value, kMostTried)) surprise += std::log(unit / spacing);
}

void DigitStatistics::note(std::string_view text, double value) {
  const Decimal number = read_decimal(text);
  const std::size_t digits = std::min(number.digits, kMostDigits);
  const auto decimals = static_cast<std::size_t>(
      std::clamp<std::int64_t>(number.decimals, 0, static_cast<std::int64_t>(kMostDecimals)));
  const bool is_small = number.has_exponent && std::abs(value) < 1;  // as JavaScript writes 0.00001
  most_of_all_ = std::max(most_of_all_, digits);
  has_full_whole_ |= number.digits == kDigitsOfG && !number.has_point && !number.has_exponent;
  if (!has_room(number) && std::abs(value) < kHuge) {
    const auto room =
        static_cast<std::size_t>(static_cast<std::int64_t>(number.digits) - number.decimals) - 1;
    least_room_ = std::min(room, least_room_.value_or(room));
  }
  has_exponent_ |= number.has_exponent;
  has_large_exponent_ |= number.has_exponent && !is_small;
  const bool is_counted = number.decimals <= static_cast<std::int64_t>(kMostDecimals);
  has_more_decimals_ |= !is_counted;
  if (number.has_point) {
    has_zeros_ |= number.ends_in_zero && number.decimals > 1 && !number.has_exponent;
    with_point_.note(value);
  }
  if (number.has_point || is_small) {
    least_decimals_ = std::min(least_decimals_, decimals);
    most_decimals_ = std::max(most_decimals_, decimals);
  }
  if (number.has_point || number.has_exponent) most_digits_ = std::max(most_digits_, digits);
  const double unit = std::pow(10.0, -static_cast<double>(number.decimals));
  if (!is_binary_fraction(number)) {
    const double of_floats = spacing_at<Scalar>(value);
    const double of_doubles = spacing_at<double>(value);
    ++rounded_;
    by_digits_[digits].note(value);
    short_[digits].note(value, unit, digits <= kWholeFloat ? of_floats : of_doubles);
    if (is_counted && (!number.has_exponent || is_small)) by_decimals_[decimals].note(value);
    open_floats_ += unit >= kManyNumbers * of_floats ? 1 : 0;
    open_doubles_ += unit >= kManyNumbers * of_doubles ? 1 : 0;
  }
  const bool is_whole_number = !number.has_point && !number.has_exponent;  // such as INT_MAX, for no bound
  if (number.digits > kLeastDigits && !is_whole_number) note_float(value, unit);
}

/// A decimal that lies between floats further apart than its unit is seldom the nearest decimal of one.
void DigitStatistics::note_float(double value, double unit) {
  constexpr double kMost = std::numeric_limits<Scalar>::max();
  if (!may_be_floats_ || std::abs(value) > kMost) return;  // beyond: DBL_MAX, for no bound
  const auto nearest = static_cast<Scalar>(value);
  const double own = 2 * std::numeric_limits<double>::epsilon() * std::abs(value);  // of 12 digits and more
  may_be_floats_ = std::abs(static_cast<double>(nearest) - value) <= 0.5000001 * unit + own;
  const double spacing = spacing_at<Scalar>(value);
  if (unit >= spacing || surprise_ >= kSurprising || !keep_once(tried_, value, kMostTried)) return;
  surprise_ += std::log(spacing / unit);
}

bool DigitStatistics::are_floats() const { return may_be_floats_ && surprise_ >= kSurprising; }

/// Whether some number has as many digits as its kind needs.
bool DigitStatistics::is_whole() const { return most_digits_ >= (are_floats() ? kWholeFloat : kWholeDouble); }

/// Whether numbers of so many digits and more are too many that have no further ones: the shortest text of a
/// float may have 7 digits, that of a double 15.
bool DigitStatistics::are_rounded(std::size_t least_digits) const {
  if (!may_be_floats_ && most_digits_ < kLeastWhole) return true;
  double surprise = 0;
  for (std::size_t k = least_digits; k <= kMostDigits; ++k) surprise += short_[k].surprise;
  return surprise >= kVerySurprising;
}

/// Whether the text of a good part leaves open which number it was.
bool DigitStatistics::are_open() const {
  return 4 * (are_floats() ? open_floats_ : open_doubles_) >= rounded_;
}

/// Whether all were written with so many decimals, zeros at the end too, and more of them than people write.
bool DigitStatistics::is_fixed() const {
  if (has_exponent_ || least_decimals_ != most_decimals_ || most_decimals_ < kLeastDecimals) return false;
  if (has_more_decimals_) return false;
  if (has_zeros_ && with_point_.some.size() >= kMany) return true;  // whatever they are
  if (!has_zeros_ && !are_rounded(0)) return false;
  std::size_t of_many_digits = 0;
  for (std::size_t k = kLeastDigits; k <= kMostDigits; ++k) of_many_digits += by_digits_[k].some.size();
  return by_decimals_[most_decimals_].some.size() >= kMany || of_many_digits >= kFew;
}

/// Whether they were rounded to so many decimals and written without the zeros at the end, as of each ten
/// numbers one has. Numbers far out have more digits before the point, and may be whole beside others.
bool DigitStatistics::is_trimmed() const {
  const Seen& longest = by_decimals_[most_decimals_];
  const bool are_many = longest.some.size() >= kMany && 5 * longest.count >= 4 * rounded_;
  const bool all_whole = is_whole() && !are_open();
  if (has_large_exponent_ || has_more_decimals_ || all_whole || most_decimals_ < kLeastDecimals || !are_many)
    return false;
  return most_digits_ < kLeastDigits || longest.count > by_digits_[most_digits_].count;
}

/// Whether they were rounded to as many digits as the longest have: of less than six, people write some, too.
bool DigitStatistics::is_cut() const {
  const Seen& longest = by_digits_[most_digits_];
  if (most_digits_ >= kLeastDigits) return longest.some.size() >= kFew && are_rounded(most_digits_);
  return most_digits_ >= kLeastShort && longest.some.size() >= kMany && 5 * longest.count >= 4 * rounded_;
}

/// Whether all may be of a program that writes so few digits that some whole numbers have no room, as 1e+06
/// by %g: any number from 999999.5 to 1000005 has this text.
bool DigitStatistics::lacks_room() const {
  return least_room_ && *least_room_ >= kDigitsOfG && most_of_all_ <= kDigitsOfG;
}

BoundRounding DigitStatistics::rounding() const {
  const auto decimals = static_cast<std::uint32_t>(most_decimals_);
  if (is_fixed() || is_trimmed()) return {0, decimals, are_floats()};
  if (!is_whole() && is_cut()) return {static_cast<std::uint32_t>(most_digits_), 0, are_floats()};
  if (!lacks_room()) return {};
  return {static_cast<std::uint32_t>(kDigitsOfG), 0, are_floats()};
}

/// The most digits that more than a few numbers have.
std::size_t DigitStatistics::usual_digits() const {
  constexpr std::size_t kMost = 8;
  std::size_t digits = most_digits_;
  if (digits <= kMost) return digits;
  std::uint64_t longer = 0;
  for (; digits > 0 && (digits > kMost || by_digits_[digits].count == 0); --digits)
    longer += by_digits_[digits].count;
  return 20 * longer <= rounded_ ? digits : 0;
}

BoundRounding DigitStatistics::suspected() const {
  if (rounding() != BoundRounding{}) return {};
  const bool same_decimals =
      !has_exponent_ && most_decimals_ > 0 && least_decimals_ == most_decimals_ && !has_more_decimals_;
  if (same_decimals && has_zeros_ && (most_decimals_ > kLeastDecimals || with_point_.count >= kMany))
    return {0, static_cast<std::uint32_t>(most_decimals_), are_floats()};
  std::size_t digits = usual_digits();
  if (!is_whole() && most_digits_ >= kLeastWhole && short_[most_digits_].surprise > 0) digits = most_digits_;
  if (digits == 0) return {};
  const auto suffice = [](const Seen& seen, bool is_long) {
    return is_long ? seen.count > 0 : seen.some.size() >= kDozens;
  };
  if (same_decimals && suffice(by_decimals_[most_decimals_], most_decimals_ > kLeastDecimals))
    return {0, static_cast<std::uint32_t>(most_decimals_), are_floats()};
  if (digits < kLeastSuspected || !suffice(by_digits_[digits], digits >= kLeastShort)) return {};
  return {static_cast<std::uint32_t>(digits), 0, are_floats()};
}

void BoundWriting::Plane::note(double min, double max) {
  holds &= min == max && min == at.value_or(min);
  at = min;
  if (max > min) least = std::min(least, max - min);
}

void BoundWriting::note(int axis, std::string_view min, std::string_view max) {
  const auto from = note(min);
  const auto to = note(max);
  if (!from || !to) return;
  Plane& plane = planes_[static_cast<std::size_t>(axis)];
  plane.note(*from, *to);
  plane.has_room &= has_room(read_decimal(min));
}

/// The number, unless it is huge.
std::optional<double> BoundWriting::note(std::string_view text) {
  const auto value = parse(text);
  if (!value) return std::nullopt;
  const bool is_huge = std::abs(*value) >= kHuge;
  (is_huge ? huge_ : usual_).note(text, *value);
  return is_huge ? std::nullopt : value;
}

/// Nothing but whole numbers shows that they may have been rounded.
bool BoundWriting::may_be_whole_only() const {
  return rounding() == BoundRounding{} && counted().suspected() == BoundRounding{} && usual_.may_lack_room();
}

BoundRounding BoundWriting::suspected() const {
  constexpr std::uint32_t kDigitsOfG = 6;
  return with_planes(may_be_whole_only() ? BoundRounding{.digits = kDigitsOfG} : counted().suspected());
}

double BoundWriting::suspected_from() const {
  constexpr double kNoDecimals = 1e5;  // six digits leave none
  return may_be_whole_only() ? kNoDecimals : 0;
}

/// Boxes that all have the same text are no planes: all of each was rounded away. Nor are boxes whose extent
/// may have been, as that of all beside 1e+06.
BoundRounding BoundWriting::with_planes(BoundRounding rounding) const {
  const auto may_differ = [](const Plane& plane) { return plane.at && !plane.holds; };
  if (rounding == BoundRounding{} || std::ranges::none_of(planes_, may_differ)) return rounding;
  const double least = std::ranges::min(planes_, {}, &Plane::least).least;
  for (std::size_t axis = 0; axis < planes_.size(); ++axis) {
    const auto& [at, holds, has_room, extent] = planes_[axis];
    if (at && holds && has_room && lost_of(rounding, *at) < least) rounding.planes |= 1U << axis;
  }
  return rounding;
}

}  // namespace kerf

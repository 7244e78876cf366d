#include "core/base/given_names.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/nearest_long_doubles.h"
#include "core/base/number_text.h"

namespace kerf {
namespace {

/// The parts of a text of fixed columns, such as "12:30:05".
std::optional<int> digits(std::string_view text, std::size_t at, std::size_t count) {
  if (text.size() < at + count) return std::nullopt;
  const std::string_view part = text.substr(at, count);
  if (part.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return read_number<int>(part);
}

/// "YYYY-MM-DD", then "T" or a space, "hh:mm:ss", a fraction if there is one, and "Z" if it is there.
std::optional<long double> parse_date(std::string_view text) {
  if (text.ends_with('Z')) text.remove_suffix(1);
  const auto year = digits(text, 0, 4);
  const auto month = digits(text, 5, 2);
  const auto day = digits(text, 8, 2);
  const auto hour = digits(text, 11, 2);
  const auto minute = digits(text, 14, 2);
  if (!year || !month || !day || !hour || !minute || text.size() < 19) return std::nullopt;
  if (text[4] != '-' || text[7] != '-' || (text[10] != 'T' && text[10] != ' ') || text[13] != ':' ||
      text[16] != ':' || !digits(text, 17, 2))
    return std::nullopt;
  const std::string_view seconds = text.substr(17);  // 60: a leap second
  if (seconds.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
  const auto second = read_number<long double>(seconds);
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!second || *second >= 61 || !date.ok() || *hour > 23 || *minute > 59) return std::nullopt;
  const NearestLongDoubles nearest;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<long double>((days * 24 + *hour) * 60 + *minute) * 60 + *second;
}

}  // namespace

std::optional<long double> parse_step_time(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto number = read_number<long double>(text);
  if (number && std::isfinite(*number)) return number;
  return parse_date(text);
}

GivenNames::GivenNames(std::vector<GivenId> objects, std::vector<std::string> steps)
    : objects_(std::move(objects)), steps_(std::move(steps)) {
  const auto falls = std::ranges::adjacent_find(objects_, std::greater_equal{});
  if (falls != objects_.end())
    throw std::invalid_argument("object " + to_string(falls[1]) + " follows object " + to_string(falls[0]));
  for (const std::string& step : steps_) {
    const auto time = parse_step_time(step);
    if (!time) throw std::invalid_argument("step '" + step + "' is neither a number nor a time");
    if (!times_.empty() && !(times_.back() < *time))
      throw std::invalid_argument("step " + step + " follows step " + steps_[times_.size() - 1]);
    times_.push_back(*time);
  }
}

GivenId GivenNames::object_id(ObjectId object) const {
  return object.index() < objects_.size() ? objects_[object.index()] : GivenId::of(object.value);
}

std::string GivenNames::pair(const Pair& pair) const {
  const auto [first, second] = std::minmax({object_id(pair.a), object_id(pair.b)});
  return to_string(first) + "," + to_string(second);
}

std::string GivenNames::step(std::uint32_t step) const {
  if (steps_.empty()) return std::to_string(step);
  if (step == 0) return "(none yet)";
  return step <= steps_.size() ? steps_[step - 1] : "(after the last)";
}

std::string GivenNames::steps(std::uint32_t first, std::uint32_t last) const {
  return "steps " + step(first) + " to " + step(last);
}

std::string GivenNames::coming_step(std::uint32_t step) const {
  return !steps_.empty() && step > steps_.size() ? "a step after the last" : "step " + this->step(step);
}

long double GivenNames::step_number(std::uint32_t step) const {
  return step >= 1 && step <= times_.size() ? times_[step - 1] : static_cast<long double>(step);
}

std::optional<ObjectId> GivenNames::find_object(const GivenId& name) const {
  if (objects_.empty()) {
    if (name.negative || name.magnitude >= UINT32_MAX) return std::nullopt;
    return ObjectId{static_cast<std::uint32_t>(name.magnitude)};
  }
  const auto found = std::ranges::lower_bound(objects_, name);
  if (found == objects_.end() || *found != name) return std::nullopt;
  return ObjectId{static_cast<std::uint32_t>(found - objects_.begin())};
}

std::optional<std::uint32_t> GivenNames::find_step(std::string_view name) const {
  if (steps_.empty()) return read_number<std::uint32_t>(name);
  const auto time = parse_step_time(name);
  if (!time) return std::nullopt;
  const auto found = std::ranges::lower_bound(times_, *time);
  if (found == times_.end() || *found != *time) return std::nullopt;
  return static_cast<std::uint32_t>(found - times_.begin()) + 1;
}

}  // namespace kerf

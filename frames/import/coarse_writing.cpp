#include "frames/import/coarse_writing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/counted.h"
#include "frames/import/written_digits.h"

namespace kerf {

void TableWriting::note(std::string_view text) {
  note_digits(text, digits_);
  const auto number = read_digits(text);
  if (!number) return;
  has_point_ |= number->has_point;
  const auto digits = static_cast<std::size_t>(number->significant);
  if (digits >= kLeastDigits) return;
  std::int64_t& least = least_decimals_[digits];
  least = has_digits_[digits] ? std::min(least, number->decimals) : number->decimals;
  has_digits_.set(digits);
}

bool TableWriting::may_be_coarse() const {
  if (digits_.significant == 0) return false;
  if (is_whole()) return true;
  return digits_.significant < kLeastDigits &&
         least_decimals_[digits_.significant] < std::int64_t{digits_.decimals};
}

std::string TableWriting::text() const {
  return is_whole() ? "no decimals" : counted(digits_.significant, "digit");
}

void Remainders::note(double number) {
  constexpr double kHuge = 1e15;  // from here on it stands for "no bound"
  if (!may_be_coarse_ || !(std::abs(number) < kHuge)) return;
  const double places = number / last_place(digits_, number);
  const double part = std::round(double{kParts} * (places - std::floor(places)));
  seen_.set(static_cast<std::size_t>(part) % kParts);
}

bool Remainders::are_many() const {
  constexpr std::size_t kMany = 6;
  return (seen_ & ~std::bitset<kParts>{1}).count() >= kMany;
}

}  // namespace kerf

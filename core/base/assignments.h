#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace kerf {

/// One "K=V", as views of the text that it stands in.
struct Assignment {
  std::string_view name;
  std::string_view value;
};

/// The parts of "K=V,K=V,...". Throws std::invalid_argument where one is not K=V.
std::vector<Assignment> parse_assignments(std::string_view text, char separator = ',');
/// Throws std::invalid_argument where a name has two values: in a program's text a later one overrides an
/// earlier one, in a user's it is a mistake.
void refuse_second_values(std::span<const Assignment> assignments);

}  // namespace kerf

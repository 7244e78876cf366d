#include "core/base/assignments.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace kerf {

std::vector<Assignment> parse_assignments(std::string_view text, char separator) {
  std::vector<Assignment> assignments;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
      throw std::invalid_argument("'" + std::string(part) + "' is not K=V, for example seed=7");
    assignments.push_back({part.substr(0, equals), part.substr(equals + 1)});
  }
  return assignments;
}

void refuse_second_values(std::span<const Assignment> assignments) {
  std::set<std::string_view> names;
  for (const Assignment& assignment : assignments)
    if (!names.insert(assignment.name).second)
      throw std::invalid_argument(std::string(assignment.name) + " has two values; leave out one of them");
}

}  // namespace kerf

#include "core/base/assignments.h"

#include <set>
#include <stdexcept>
#include <string>

namespace kerf {

std::vector<Assignment> parse_assignments(std::string_view text, char separator) {
  std::vector<Assignment> assignments;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::string_view part = text.substr(begin, text.find(separator, begin) - begin);
    begin += part.size() + 1;
    if (part.empty())
      throw std::invalid_argument("'" + std::string(text) + "' has an empty item; leave out the '" +
                                  separator + "' beside it");
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

#include "frames/support/suggest.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace kerf {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0U : 1U);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row[b.size()];
}

std::string_view nearest_name(std::string_view given, std::span<const std::string> names) {
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(given, name);
    if (distance >= least) continue;
    least = distance;
    best = name;
  }
  return best;
}

std::string unknown_name_message(std::string_view kind, std::string_view given,
                                 std::span<const std::string> names) {
  std::string text = "unknown " + std::string(kind) + " '" + std::string(given) + "'";
  if (const std::string_view near = nearest_name(given, names); !near.empty()) {
    text += "; did you mean '" + std::string(near) + "'?";
  } else {
    text += ".";
  }
  text += " Choose from:";
  for (const std::string& name : names) text += (&name == names.data() ? " " : ", ") + name;
  return text;
}

}  // namespace kerf

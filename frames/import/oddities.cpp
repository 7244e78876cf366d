#include "frames/import/oddities.h"

#include <algorithm>

namespace kerf {
namespace {

/// In the order of the enumeration.
constexpr std::array<std::string_view, 9> kMeanings{
    "gaps between steps, at least half as long again as most",
    "steps with pairs and without a line of boxes: the boxes stay",
    "boxes that are half blank: the object is in quarantine",
    "boxes that are not numbers: the object is in quarantine",
    "boxes that are inverted, min > max: the object is in quarantine",
    "boxes that reach to infinity",
    "changes between fixed and moving",
    "steps in which an object has several boxes, which were united",
    "pairs with an object that is not there",
};

}  // namespace

bool Oddities::any() const {
  return std::ranges::any_of(kinds_, [](const Kind& kind) { return kind.count > 0; });
}

std::string Oddities::text() const {
  std::string text;
  for (std::size_t k = 0; k < kKinds; ++k) {
    const Kind& kind = kinds_[k];
    if (kind.count == 0) continue;
    text += "odd: " + std::to_string(kind.count) + " " + std::string(kMeanings[k]) + "\n";
    for (const std::string& place : kind.places) text += "  " + place + "\n";
    if (kind.count > kind.places.size())
      text += "  and " + std::to_string(kind.count - kind.places.size()) + " more\n";
  }
  return text;
}

}  // namespace kerf

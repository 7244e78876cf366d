#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kerf {

/// A text beside a point of a picture; pixels, y downwards.
struct LabelWish {
  double x = 0;
  double y = 0;
  std::string text;
};

/// The place of a text: its left end and its middle line.
struct LabelPlace {
  double x = 0;
  double y = 0;
};

/// A place for each text beside its point, such that no two overlap, none covers another point, and all are
/// inside the picture's width; none where there is no such place. Earlier texts choose first. `obstacles` are
/// further points.
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelWish>& wishes,
                                                    const std::vector<LabelWish>& obstacles, double left,
                                                    double right);

}  // namespace kerf

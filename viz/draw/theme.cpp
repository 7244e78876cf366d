#include "viz/draw/theme.h"

#include <algorithm>

#include "viz/draw/palette.h"

namespace kerf {
namespace {

/// What stands for a colour of the palette.
struct Role {
  Color palette;
  Color light_text;
  Color dark_text;
  Color dark_mark;
};

constexpr Color kBlueText{0, 94, 150};
constexpr Color kPaleBlue{120, 190, 240};
constexpr Color kGreyText{86, 86, 86};
constexpr Color kPaleGrey{186, 186, 182};
constexpr Color kPaleInk{230, 230, 226};

constexpr std::array kRoles{Role{palette::kInk, palette::kInk, kPaleInk, kPaleInk},
                            Role{palette::kContact, palette::kContact, kPaleInk, kPaleInk},
                            Role{palette::kFaintInk, kGreyText, kPaleGrey, {160, 160, 156}},
                            Role{palette::kFixed, kGreyText, kPaleGrey, palette::kFixed},
                            Role{palette::kPartitioner, kBlueText, kPaleBlue, {90, 170, 230}},
                            Role{palette::kCandidate, {160, 62, 0}, {255, 155, 95}, {240, 125, 50}},
                            Role{palette::kOperator, {176, 0, 100}, {255, 140, 205}, {255, 100, 185}},
                            Role{palette::kSeries[2], {0, 105, 75}, {70, 205, 160}, {40, 185, 140}},
                            Role{palette::kLanes[2], {0, 105, 75}, {70, 205, 160}, {40, 185, 140}},
                            Role{palette::kLanes[3], palette::kLanes[3], {215, 135, 180}, {215, 135, 180}},
                            Role{palette::kSelected, palette::kSelected, {235, 165, 30}, {235, 165, 30}},
                            Role{palette::kLanes[5], palette::kLanes[5], {110, 190, 240}, {110, 190, 240}}};

const Role* role_of(Color color) {
  color.a = 255;
  const auto found = std::ranges::find(kRoles, color, &Role::palette);
  return found == kRoles.end() ? nullptr : &*found;
}

Color with_alpha_of(Color color, Color alpha) { return {color.r, color.g, color.b, alpha.a}; }

constexpr Theme kLight{.name = ThemeName::light,
                       .scene = palette::kGround,
                       .panel = palette::kPanel,
                       .list = {248, 248, 245},
                       .paper = {255, 255, 255},
                       .popup = {252, 252, 250},
                       .field = {255, 255, 255},
                       .button = {222, 226, 230},
                       .hovered = {198, 220, 236},
                       .pressed = {150, 195, 225},
                       .selected = {212, 230, 243},
                       .row_hovered = {228, 238, 245},
                       .table_header = {228, 228, 222},
                       .odd_row = {238, 238, 235},
                       .border = {200, 200, 194},
                       .divider = {0, 114, 178}};

constexpr Theme kDark{.name = ThemeName::dark,
                      .scene = {28, 29, 32},
                      .panel = {40, 42, 46},
                      .list = {30, 32, 35},
                      .paper = {22, 23, 26},
                      .popup = {34, 36, 39},
                      .field = {24, 25, 28},
                      .button = {60, 64, 70},
                      .hovered = {66, 84, 100},
                      .pressed = {44, 92, 130},
                      .selected = {40, 62, 82},
                      .row_hovered = {42, 52, 62},
                      .table_header = {52, 54, 58},
                      .odd_row = {38, 40, 44},
                      .border = {72, 75, 80},
                      .divider = {90, 170, 230}};

}  // namespace

Color Theme::text(Color palette_color) const {
  const Role* const role = role_of(palette_color);
  if (role == nullptr) return palette_color;
  return with_alpha_of(name == ThemeName::light ? role->light_text : role->dark_text, palette_color);
}

Color Theme::mark(Color palette_color) const {
  if (name == ThemeName::light) return palette_color;
  const Role* const role = role_of(palette_color);
  return role == nullptr ? palette_color : with_alpha_of(role->dark_mark, palette_color);
}

const Theme& theme_called(ThemeName name) { return name == ThemeName::light ? kLight : kDark; }

}  // namespace kerf

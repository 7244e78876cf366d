#include "viz/debugger/window/arrangement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace kerf {
namespace {

constexpr float kLeastCellHeight = 64;
constexpr float kLeastColumn = 180;
constexpr float kLeastView = 250;       // its width
constexpr float kLeastViewHeight = 90;  // without its tools
constexpr float kLeastRow = 90;         // the height of the panels below
constexpr float kLeastTimeline = 480;   // its width,
constexpr float kTimelineHeight = 212;  // and its height with the lanes of each run
constexpr float kLaneHeight = 15;       // the height of a lane with a line of text
constexpr float kTabs = 418;            // the width of all tabs side by side
constexpr float kTransportInOneRow = 958;
constexpr float kLeastTransport = 640;
constexpr float kToolsInTwoRows =
    600;                              // the width of the view's tools in two rows; below it they take three,
constexpr float kToolsInThree = 450;  // and below this one four
constexpr float kGrip = 6;            // the width in which the mouse takes a divider

/// The two directions of a place: cells are divided along one of them.
bool is_row(PanelPlace place) { return place == PanelPlace::below; }

bool has_timeline(const PanelCell& cell) {
  return std::ranges::find(cell.tabs, PanelId::timeline) != cell.tabs.end();
}

float least_width(const PanelCell& cell) { return has_timeline(cell) ? kLeastTimeline : kLeastColumn; }

float least_height(const PanelCell& cell, std::size_t lanes) {
  return has_timeline(cell) ? kTimelineHeight + kLaneHeight * static_cast<float>(lanes) : kLeastCellHeight;
}

/// The sum of a measure over the cells of a place, or its maximum across them.
template <class Measure>
float sum_over(const std::vector<PanelCell>& cells, Measure measure) {
  return std::accumulate(cells.begin(), cells.end(), 0.0F,
                         [&](float sum, const PanelCell& cell) { return sum + measure(cell); });
}
template <class Measure>
float most_of(const std::vector<PanelCell>& cells, Measure measure) {
  return std::accumulate(cells.begin(), cells.end(), 0.0F,
                         [&](float most, const PanelCell& cell) { return std::max(most, measure(cell)); });
}

/// The choice takes a row of its own where two rows do not suffice.
float tools_height(float room, bool has_choice) {
  if (room >= kToolsInTwoRows) return 58;
  return has_choice || room < kToolsInThree ? 106 : 82;
}
float transport_height(float width) { return width < kTransportInOneRow ? 82 : 58; }

/// Least sizes of the three places.
struct Leasts {
  float left = 0;
  float right = 0;
  float below = 0;
};
Leasts leasts_of(const WindowLayout& layout, std::size_t lanes) {
  const auto wide = [&](PanelPlace place) { return most_of(layout.cells(place), least_width); };
  const auto& row = layout.cells(PanelPlace::below);
  const float high = most_of(row, [&](const PanelCell& cell) { return least_height(cell, lanes); });
  return {wide(PanelPlace::left), wide(PanelPlace::right), row.empty() ? 0 : std::max(high, kLeastRow)};
}

struct PlaceExtents {
  float left = 0;
  float right = 0;
  float below = 0;
};

PlaceExtents extents_of(const WindowLayout& layout, const WindowSize& size) {
  const Leasts least = leasts_of(layout, size.lanes);
  const auto wanted = [&](PanelPlace place, float whole, float usual) {
    if (layout.cells(place).empty()) return 0.0F;
    const auto share = layout.extent(place);
    return std::floor(share ? *share * whole : usual);
  };
  const float w = size.width;
  const float h = size.height;
  PlaceExtents extents{wanted(PanelPlace::left, w, std::clamp(0.19F * w, 210.0F, 330.0F)),
                       wanted(PanelPlace::right, w, std::clamp(0.335F * w, kTabs, 560.0F)),
                       wanted(PanelPlace::below, h, std::max(least.below, std::min(0.28F * h, 300.0F)))};
  extents.left = std::max(extents.left, least.left);
  extents.right = std::max(extents.right, least.right);
  const float room =
      h - transport_height(w) - tools_height(w - extents.left - extents.right, size.has_choice);
  extents.below = std::max(least.below, std::min(extents.below, room - kLeastViewHeight));
  // In a narrow window both columns give way.
  const float columns = w - kLeastView;
  const float both = extents.left + extents.right;
  if (both <= columns) return extents;
  const float spare = both - least.left - least.right;
  const float share = spare > 0 ? std::clamp((columns - least.left - least.right) / spare, 0.0F, 1.0F) : 0;
  extents.left = std::floor(least.left + share * (extents.left - least.left));
  extents.right = std::floor(least.right + share * (extents.right - least.right));
  return extents;
}

/// Divides a room by shares; none gets less than its least size as long as there is room for all.
std::vector<float> divide_room(float room, const std::vector<PanelCell>& cells,
                               std::span<const float> least) {
  std::vector<float> sizes(cells.size());
  std::vector<bool> is_least(cells.size());
  const float all_least = std::accumulate(least.begin(), least.end(), 0.0F);
  const float given = all_least > room && all_least > 0 ? room / all_least : 1;
  for (bool again = true; again;) {
    again = false;
    double left = double{room};
    double shares = 0;
    for (std::size_t k = 0; k < cells.size(); ++k)
      (is_least[k] ? left : shares) += is_least[k] ? double{-least[k] * given} : double{cells[k].share};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      constexpr double kRounding = 1e-3;
      sizes[k] = is_least[k]
                     ? least[k] * given
                     : static_cast<float>(std::floor(double{cells[k].share} * left / shares + kRounding));
      if (is_least[k] || sizes[k] >= std::floor(least[k] * given)) continue;
      is_least[k] = again = true;
    }
  }
  if (!sizes.empty()) sizes.back() = room - std::accumulate(sizes.begin(), sizes.end() - 1, 0.0F);
  return sizes;
}

void place_cells(const WindowLayout& layout, PanelPlace place, const PanelArea& area, Arrangement& result) {
  const auto& cells = layout.cells(place);
  std::vector<float> least;
  least.reserve(cells.size());
  for (const PanelCell& cell : cells)
    least.push_back(is_row(place) ? least_width(cell) : least_height(cell, result.size.lanes));
  const auto sizes = divide_room(is_row(place) ? area.width : area.height, cells, least);
  PanelArea rest = area;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    PanelArea part = rest;
    (is_row(place) ? part.width : part.height) = sizes[k];
    (is_row(place) ? rest.x : rest.y) += sizes[k];
    result.cells.push_back({{place, k}, part});
    if (k + 1 == cells.size()) continue;
    const std::string name =
        "divider " + std::string(kPlaceNames[static_cast<std::size_t>(place)]) + " " + std::to_string(k + 1);
    const PanelArea grip = is_row(place) ? PanelArea{part.right() - kGrip / 2, part.y, kGrip, part.height}
                                         : PanelArea{part.x, part.bottom() - kGrip / 2, part.width, kGrip};
    result.dividers.push_back({name, {place, k}, true, is_row(place), grip});
  }
}

void add_outer_dividers(const WindowLayout& layout, Arrangement& result) {
  const auto add = [&](PanelPlace place, bool is_upright, const PanelArea& area) {
    if (layout.cells(place).empty()) return;
    const std::string name = "divider " + std::string(kPlaceNames[static_cast<std::size_t>(place)]);
    result.dividers.push_back({name, {place, 0}, false, is_upright, area});
  };
  const float top = result.tools.y;
  const float height = result.view.bottom() - top;
  add(PanelPlace::left, true, {result.view.x - kGrip / 2, top, kGrip, height});
  add(PanelPlace::right, true, {result.view.right() - kGrip / 2, top, kGrip, height});
  add(PanelPlace::below, false, {0, result.view.bottom() - kGrip / 2, result.size.width, kGrip});
}

}  // namespace

const PanelArea* Arrangement::find(const CellIndex& cell) const {
  const auto found = std::ranges::find(cells, cell, &ArrangedCell::index);
  return found == cells.end() ? nullptr : &found->area;
}

Arrangement arrange(const WindowLayout& layout, const WindowSize& size) {
  const PlaceExtents extents = extents_of(layout, size);
  Arrangement result;
  result.size = size;
  const float top = transport_height(size.width);
  const float room = size.width - extents.left - extents.right;
  const float middle = size.height - top - extents.below;
  const float tools = tools_height(room, size.has_choice);
  result.transport = {0, 0, size.width, top};
  result.tools = {extents.left, top, room, tools};
  result.view = {extents.left, top + tools, room, middle - tools};
  place_cells(layout, PanelPlace::left, {0, top, extents.left, middle}, result);
  place_cells(layout, PanelPlace::right, {size.width - extents.right, top, extents.right, middle}, result);
  place_cells(layout, PanelPlace::below, {0, size.height - extents.below, size.width, extents.below}, result);
  add_outer_dividers(layout, result);
  return result;
}

PanelArea area_of(PanelId panel, const WindowLayout& layout, const Arrangement& arrangement) {
  const auto at = layout.find(panel);
  const PanelArea* const area = at ? arrangement.find(*at) : nullptr;
  return area == nullptr ? PanelArea{} : *area;
}

WindowSize least_window(const WindowLayout& layout, std::size_t lanes) {
  const Leasts least = leasts_of(layout, lanes);
  const auto high = [&](PanelPlace place) {
    return sum_over(layout.cells(place), [&](const PanelCell& cell) { return least_height(cell, lanes); });
  };
  const float row = sum_over(layout.cells(PanelPlace::below), least_width);
  const float width = std::max({kLeastTransport, row, least.left + kLeastView + least.right});
  const float view = tools_height(kLeastView, true) + kLeastViewHeight;
  const float middle = std::max({view, high(PanelPlace::left), high(PanelPlace::right)});
  return {width, transport_height(width) + middle + least.below, lanes};
}

void drag_divider(WindowLayout& layout, const Arrangement& arrangement, const Divider& divider, float x,
                  float y) {
  const WindowSize& size = arrangement.size;
  const PanelPlace place = divider.cell.place;
  if (divider.is_inner) {
    const PanelArea* const a = arrangement.find(divider.cell);
    const PanelArea* const b = arrangement.find({place, divider.cell.cell + 1});
    if (a == nullptr || b == nullptr) return;
    const auto& cells = layout.cells(place);
    const auto least = [&](std::size_t k) {
      return is_row(place) ? least_width(cells[k]) : least_height(cells[k], size.lanes);
    };
    const float both = is_row(place) ? a->width + b->width : a->height + b->height;
    const float wanted = is_row(place) ? x - a->x : y - a->y;
    const float first = least(divider.cell.cell);
    const float last = both - least(divider.cell.cell + 1);
    if (last >= first) layout.divide(divider.cell, std::clamp(wanted, first, last) / both);
    return;
  }
  const Leasts least = leasts_of(layout, size.lanes);
  const PanelArea& view = arrangement.view;
  if (place == PanelPlace::below) {
    const float most = size.height - view.y - kLeastViewHeight;
    if (most >= least.below)
      layout.set_extent(place, std::clamp(size.height - y, least.below, most) / size.height);
    return;
  }
  const bool is_left = place == PanelPlace::left;
  const float most = (is_left ? view.right() : size.width - view.x) - kLeastView;
  const float lowest = is_left ? least.left : least.right;
  if (most >= lowest)
    layout.set_extent(place, std::clamp(is_left ? x : size.width - x, lowest, most) / size.width);
}

void reset_divider(WindowLayout& layout, const Divider& divider) {
  if (divider.is_inner) {
    layout.reset_shares(divider.cell.place);
  } else {
    layout.set_extent(divider.cell.place, std::nullopt);
  }
}

}  // namespace kerf

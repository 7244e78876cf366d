#include "viz/debugger/window/window_layout.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

constexpr float kMostShare = 1e3F;

std::array<std::vector<PanelCell>, 3> default_places() {
  using enum PanelId;
  return {
      std::vector<PanelCell>{{{tree}, 0, 0.4F}, {{icicle}, 0, 0.24F}, {{breakpoints}, 0, 0.36F}},
      std::vector<PanelCell>{{{events}, 0, 0.36F},
                             {{why, ballot, algorithm, oracle, what_if, compare, lint, tables}, 0, 0.64F}},
      std::vector<PanelCell>{{{timeline}, 0, 1}}};
}

bool has_panel(const PanelCell& cell, PanelId panel) {
  return std::ranges::find(cell.tabs, panel) != cell.tabs.end();
}

/// The cell that has a panel by default.
CellIndex default_cell(PanelId panel) {
  const auto places = default_places();
  for (const PanelPlace place : kPanelPlaces) {
    const auto& cells = places[static_cast<std::size_t>(place)];
    const auto found =
        std::ranges::find_if(cells, [&](const PanelCell& cell) { return has_panel(cell, panel); });
    if (found != cells.end()) return {place, static_cast<std::size_t>(found - cells.begin())};
  }
  return {};
}

float default_share(PanelId panel) {
  const CellIndex at = default_cell(panel);
  return default_places()[static_cast<std::size_t>(at.place)][at.cell].share;
}

}  // namespace

std::optional<PanelId> panel_titled(std::string_view title) {
  const auto found = std::ranges::find(kPanelTitles, title);
  if (found == kPanelTitles.end()) return std::nullopt;
  return static_cast<PanelId>(found - kPanelTitles.begin());
}

WindowLayout::WindowLayout() : places_(default_places()) {}

WindowLayout::WindowLayout(std::array<std::vector<PanelCell>, 3> places) : places_(std::move(places)) {
  std::vector<PanelId> seen;
  for (auto& cells : places_)
    for (PanelCell& cell : cells) {
      if (cell.tabs.empty()) throw std::invalid_argument("a cell has no panel");
      if (!(cell.share > 0 && cell.share < kMostShare))
        throw std::invalid_argument("the share of a cell is not above 0, or too large");
      if (cell.shown >= cell.tabs.size()) throw std::invalid_argument("a cell has no such tab in front");
      for (const PanelId panel : cell.tabs) {
        if (std::ranges::find(seen, panel) != seen.end())
          throw std::invalid_argument("the panel " + std::string(title_of(panel)) + " is there twice");
        seen.push_back(panel);
      }
    }
}

std::optional<CellIndex> WindowLayout::find(PanelId panel) const {
  for (const PanelPlace place : kPanelPlaces)
    for (std::size_t k = 0; k < cells(place).size(); ++k)
      if (has_panel(cells(place)[k], panel)) return CellIndex{place, k};
  return std::nullopt;
}

bool WindowLayout::is_in_front(PanelId panel) const {
  const auto at = find(panel);
  if (!at) return false;
  const PanelCell& cell = cells(at->place)[at->cell];
  return cell.tabs[cell.shown] == panel;
}

/// Cells that become empty stay until the caller has used their numbers.
void WindowLayout::remove(PanelId panel) {
  const auto at = find(panel);
  if (!at) return;
  PanelCell& cell = places_[index(at->place)][at->cell];
  const auto tab = static_cast<std::size_t>(std::ranges::find(cell.tabs, panel) - cell.tabs.begin());
  cell.tabs.erase(cell.tabs.begin() + static_cast<std::ptrdiff_t>(tab));
  if (cell.shown > tab || cell.shown == cell.tabs.size()) cell.shown -= cell.shown > 0 ? 1 : 0;
}

void WindowLayout::move(PanelId panel, const DropTarget& target) {
  remove(panel);
  auto& cells = places_[index(target.cell.place)];
  const bool is_beside = target.side != DropSide::tab || target.cell.cell >= cells.size();
  if (!is_beside) {
    PanelCell& cell = cells[target.cell.cell];
    cell.tabs.push_back(panel);
    cell.shown = cell.tabs.size() - 1;
  } else if (cells.empty()) {
    cells.push_back({{panel}, 0, 1});
  } else {
    const std::size_t k = std::min(target.cell.cell, cells.size() - 1);
    PanelCell& neighbour = cells[k];
    if (!neighbour.tabs.empty()) neighbour.share *= 0.5F;
    const std::size_t at = k + (target.side == DropSide::before ? 0 : 1);
    cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(at), PanelCell{{panel}, 0, neighbour.share});
  }
  for (auto& place : places_) std::erase_if(place, [](const PanelCell& cell) { return cell.tabs.empty(); });
}

void WindowLayout::move_to_end(PanelId panel, PanelPlace place) {
  const std::size_t count = cells(place).size();
  move(panel, {{place, count > 0 ? count - 1 : 0}, DropSide::after});
}

void WindowLayout::close(PanelId panel) {
  remove(panel);
  for (auto& place : places_) std::erase_if(place, [](const PanelCell& cell) { return cell.tabs.empty(); });
}

void WindowLayout::show(PanelId panel) {
  if (const auto at = find(panel)) {
    PanelCell& cell = places_[index(at->place)][at->cell];
    cell.shown = static_cast<std::size_t>(std::ranges::find(cell.tabs, panel) - cell.tabs.begin());
    return;
  }
  const CellIndex home = default_cell(panel);
  // As a tab beside those with which it shares a cell by default.
  const std::vector<PanelId> neighbours = default_places()[index(home.place)][home.cell].tabs;
  for (const PanelId other : neighbours)
    if (const auto at = find(other)) return move(panel, {*at, DropSide::tab});
  auto& cells = places_[index(home.place)];
  const auto next = std::ranges::find_if(cells, [&](const PanelCell& cell) {
    return std::ranges::any_of(
        cell.tabs, [&](PanelId other) { return other > panel && default_cell(other).place == home.place; });
  });
  cells.insert(next, PanelCell{{panel}, 0, default_share(panel)});
}

void WindowLayout::divide(const CellIndex& first_cell, float first) {
  auto& cells = places_[index(first_cell.place)];
  PanelCell& a = cells[first_cell.cell];
  PanelCell& b = cells[first_cell.cell + 1];
  const float both = a.share + b.share;
  a.share = both * first;
  b.share = both - a.share;
}

void WindowLayout::reset_shares(PanelPlace place) {
  auto& cells = places_[index(place)];
  const auto usual = default_places()[index(place)];
  const auto has_usual_panel = [&](const PanelCell& cell) {
    return default_cell(cell.tabs.front()).place == place;
  };
  const bool is_usual = cells.size() == usual.size() && std::ranges::all_of(cells, has_usual_panel);
  for (PanelCell& cell : cells) cell.share = is_usual ? default_share(cell.tabs.front()) : 1;
}

}  // namespace kerf

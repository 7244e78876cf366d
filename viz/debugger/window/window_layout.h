#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace kerf {

/// A panel that can be moved and closed. What is above the lanes and columns, and the view, stay.
enum class PanelId : std::uint8_t {
  tree,
  icicle,
  breakpoints,
  events,
  why,
  ballot,
  algorithm,
  oracle,
  what_if,
  compare,
  lint,
  tables,
  timeline,
};
inline constexpr std::size_t kPanelCount = 13;
inline constexpr std::array<std::string_view, kPanelCount> kPanelTitles{
    "Tree",   "Icicle",  "Breakpoints", "Events", "Why",    "Ballot",  "Algorithm",
    "Oracle", "What if", "Compare",     "Lint",   "Tables", "Timeline"};
constexpr std::string_view title_of(PanelId panel) { return kPanelTitles[static_cast<std::size_t>(panel)]; }
std::optional<PanelId> panel_titled(std::string_view title);

/// Beside the view: two columns, in which cells stand above each other, and a row below all, in which they
/// stand side by side.
enum class PanelPlace : std::uint8_t { left, right, below };
inline constexpr std::array<PanelPlace, 3> kPanelPlaces{PanelPlace::left, PanelPlace::right,
                                                        PanelPlace::below};
inline constexpr std::array<std::string_view, 3> kPlaceNames{"left", "right", "below"};

/// One panel, or several as tabs.
struct PanelCell {
  std::vector<PanelId> tabs;
  std::size_t shown = 0;  ///< the tab in front
  float share = 1;        ///< of its place, measured by those of the other cells
  friend bool operator==(const PanelCell&, const PanelCell&) = default;
};

/// A cell by its place and its number there.
struct CellIndex {
  PanelPlace place = PanelPlace::left;
  std::size_t cell = 0;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

/// Where a panel is put: beside a cell, or as a tab of it. In an empty place all are the same.
enum class DropSide : std::uint8_t { before, after, tab };
struct DropTarget {
  CellIndex cell;
  DropSide side = DropSide::after;
  friend bool operator==(const DropTarget&, const DropTarget&) = default;
};

/// Which panels are where, and the sizes that the user chose. Every panel is in one cell at most, and no cell
/// is empty.
class WindowLayout {
 public:
  /// The default.
  WindowLayout();
  /// For layouts that were written down. Throws std::invalid_argument if a panel is there twice, a cell is
  /// empty, or a share is not positive.
  explicit WindowLayout(std::array<std::vector<PanelCell>, 3> places);

  [[nodiscard]] const std::vector<PanelCell>& cells(PanelPlace place) const { return places_[index(place)]; }
  [[nodiscard]] std::optional<CellIndex> find(PanelId panel) const;
  [[nodiscard]] bool is_open(PanelId panel) const { return find(panel).has_value(); }
  /// Open, and not behind another tab.
  [[nodiscard]] bool is_in_front(PanelId panel) const;

  /// The target counts cells as they are before the move.
  void move(PanelId panel, const DropTarget& target);
  /// Into a cell of its own at the end of a place.
  void move_to_end(PanelId panel, PanelPlace place);
  void close(PanelId panel);
  /// Opens it near where it is by default, and brings its tab to the front.
  void show(PanelId panel);

  /// The width of a column, or the height of the row below, as a share of the window; none: the default.
  [[nodiscard]] std::optional<float> extent(PanelPlace place) const { return extents_[index(place)]; }
  void set_extent(PanelPlace place, std::optional<float> share) { extents_[index(place)] = share; }
  /// Divides what a cell and the next one have; `first` is the share of the first.
  void divide(const CellIndex& first_cell, float first);
  /// The cells of a place are as large as by default, or equal where other panels are in them.
  void reset_shares(PanelPlace place);

  friend bool operator==(const WindowLayout&, const WindowLayout&) = default;

 private:
  static std::size_t index(PanelPlace place) { return static_cast<std::size_t>(place); }
  void remove(PanelId panel);

  std::array<std::vector<PanelCell>, 3> places_;
  std::array<std::optional<float>, 3> extents_;
};

}  // namespace kerf

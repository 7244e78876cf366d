#include "viz/debugger/window/window_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "core/base/number_text.h"

namespace kerf {
namespace {

constexpr std::string_view kFirstLine = "# How the window of `kerf debug` looks.";
constexpr std::string_view kLastLine = "end";
constexpr auto kZooms = std::to_array({0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0});

std::string number_word(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 5);
  return {text.data(), end.ptr};
}

[[noreturn]] void reject(const std::string& what) { throw std::invalid_argument(what); }

template <class Number>
Number number_in(const std::string& word) {
  const auto value = read_number<Number>(word);
  if (!value) reject("'" + word + "' is no number");
  return *value;
}

/// The number of a name in a list of names.
template <std::size_t N>
std::size_t index_of_name(const std::array<std::string_view, N>& names, const std::string& word) {
  const auto found = std::ranges::find(names, word);
  if (found == names.end()) reject("'" + word + "' is unknown");
  return static_cast<std::size_t>(found - names.begin());
}

double read_share(const std::string& word) {
  const auto share = number_in<double>(word);
  if (!(share > 0 && share < 1)) reject("'" + word + "' is no share between 0 and 1");
  return share;
}

/// "Why, What if"
std::vector<PanelId> panels_of(std::istringstream& words) {
  std::vector<PanelId> panels;
  for (std::string title; std::getline(words >> std::ws, title, ',');) {
    const auto panel = panel_titled(title);
    if (!panel) reject("there is no panel '" + title + "'");
    panels.push_back(*panel);
  }
  return panels;
}

/// What the lines of a file have said so far.
struct SettingsLines {
  WindowSettings settings;
  std::array<std::vector<PanelCell>, 3> places;
  std::array<std::optional<float>, 3> extents;
  bool has_end = false;

  void take(const std::string& line) {
    if (line.empty() || line.front() == '#') return;
    std::istringstream words(line);
    std::string what;
    std::string first;
    std::string second;
    words >> what;
    if (what == kLastLine) {
      has_end = true;
    } else if (what == "zoom" && words >> first) {
      settings.zoom = number_in<double>(first);
      if (!(settings.zoom >= kZooms.front() && settings.zoom <= kZooms.back()))
        reject("the zoom is from " + number_word(kZooms.front()) + " to " + number_word(kZooms.back()));
    } else if (what == "theme" && words >> first) {
      settings.theme = static_cast<ThemeName>(index_of_name(kThemeNames, first));
    } else if (what == "size" && words >> first >> second) {
      extents[index_of_name(kPlaceNames, first)] = static_cast<float>(read_share(second));
    } else if (what == "cell" && words >> first >> second) {
      std::string front;
      words >> front;
      PanelCell cell;
      cell.share = static_cast<float>(number_in<double>(second));
      cell.shown = number_in<std::size_t>(front);
      cell.tabs = panels_of(words);
      places[index_of_name(kPlaceNames, first)].push_back(std::move(cell));
    } else {
      reject("it is none of: zoom, theme, size, cell, end");
    }
  }
};

}  // namespace

void WindowSettings::zoom_by(bool larger) {
  constexpr double kSame = 1e-3;
  if (larger) {
    const auto next = std::ranges::upper_bound(kZooms, zoom + kSame);
    zoom = next == kZooms.end() ? kZooms.back() : *next;
  } else {
    const auto next = std::ranges::lower_bound(kZooms, zoom - kSame);
    zoom = next == kZooms.begin() ? kZooms.front() : *(next - 1);
  }
}

std::string to_text(const WindowSettings& settings) {
  std::string text = std::string(kFirstLine) + "\n";
  text += "theme " + std::string(kThemeNames[static_cast<std::size_t>(settings.theme)]) + "\n";
  text += "zoom " + number_word(settings.zoom) + "\n";
  for (const PanelPlace place : kPanelPlaces) {
    const std::string name(kPlaceNames[static_cast<std::size_t>(place)]);
    if (const auto extent = settings.layout.extent(place))
      text += "size " + name + " " + number_word(double{*extent}) + "\n";
    for (const PanelCell& cell : settings.layout.cells(place)) {
      text += "cell " + name + " " + number_word(double{cell.share}) + " " + std::to_string(cell.shown);
      for (const PanelId panel : cell.tabs)
        text += std::string(panel == cell.tabs.front() ? " " : ", ") + std::string(title_of(panel));
      text += "\n";
    }
  }
  return text + std::string(kLastLine) + "\n";
}

WindowSettings parse_window_settings(std::string_view text) {
  SettingsLines lines;
  std::istringstream stream{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    try {
      lines.take(line);
    } catch (const std::invalid_argument& error) {
      reject("line " + std::to_string(number) + ", '" + line + "': " + error.what());
    }
  }
  if (!lines.has_end) reject("its end is missing");
  lines.settings.layout = WindowLayout(std::move(lines.places));
  for (const PanelPlace place : kPanelPlaces)
    lines.settings.layout.set_extent(place, lines.extents[static_cast<std::size_t>(place)]);
  return lines.settings;
}

}  // namespace kerf

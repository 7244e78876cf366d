#include "tests/house/architecture.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "tests/house/include_rules.h"
#include "tests/house/project_files.h"
#include "tests/house/svg.h"

namespace kerf::house {
namespace {

constexpr int kRow = 32;     // from one layer to the next
constexpr int kTitle = 38;   // height of a panel's title
constexpr int kMargin = 52;  // room for arcs, left of the layers
constexpr int kGap = 46;     // between two panels of a column

/// A room in the drawing. Its layers stand in rows, the lowest at the bottom.
struct Panel {
  std::string_view room;
  std::string_view title;
  std::string_view fill;
  Point corner;
  int width = 0;
  std::vector<Layer> layers;

  [[nodiscard]] int height() const {
    return kTitle + static_cast<int>(layers.size()) * kRow + (layers.empty() ? 0 : 8);
  }
  [[nodiscard]] int bottom() const { return corner.y + height(); }
  [[nodiscard]] int right() const { return corner.x + width; }
};

std::vector<Layer> layers_in(std::string_view room) {
  std::vector<Layer> found;
  std::ranges::copy_if(layers(), std::back_inserter(found),
                       [&](const Layer& layer) { return layer.folder.starts_with(room); });
  return found;
}

/// The rooms in two columns. A room is narrower than the one above it where that one's arrow passes it.
std::vector<Panel> panels() {
  std::vector<Panel> all = {
      {"frames/", "frames: the program kerf", "#fdf3e1", {20, 20}, 560, {}},
      {"viz/", "viz: drawing and the debugger", "#e8f2e4", {20, 0}, 560, {}},
      {"sims2d/", "sims2d: Box2D driven by a broad phase; 2D scenes", "#f3e8f4", {640, 120}, 560, {}},
      {"sims3d/", "sims3d: ODE driven by a broad phase; 3D scenes", "#f3e8f4", {640, 0}, 490, {}},
      {"core/", "core: the broad phase and its recordings", "#e3edf7", {640, 0}, 560, {}},
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].layers = layers_in(all[k].room);
    if (all[k].corner.y == 0) all[k].corner.y = all[k - 1].bottom() + kGap;
  }
  return all;
}

/// The folder as it is seen from its room: "tree", "debugger/gui".
std::string short_name(const Layer& layer) {
  std::string name(layer.folder.substr(layer.folder.find('/') + 1));
  if (name.ends_with('/')) name.pop_back();
  return name;
}

std::set<std::string> at(const Edges& edges, const std::string& place) {
  const auto found = edges.find(place);
  return found == edges.end() ? std::set<std::string>{} : found->second;
}

/// The middle of the left side of a layer's row.
Point row_of(const Panel& panel, std::size_t index) {
  return {panel.corner.x + kMargin, panel.bottom() - static_cast<int>(index) * kRow - kRow / 2 - 4};
}

void draw_rows(const Panel& panel, Svg& svg) {
  for (std::size_t k = 0; k < panel.layers.size(); ++k) {
    const Point left = row_of(panel, k);
    svg.box({left.x, left.y - 13}, panel.width - kMargin - 12, 26, "white", "#999");
    svg.text({left.x + 8, left.y + 4}, short_name(panel.layers[k]), "font-weight=\"bold\"");
    svg.text({left.x + 135, left.y + 4}, panel.layers[k].purpose, "fill=\"#444\" font-size=\"11\"");
  }
}

/// An arc for each edge between two layers of the panel.
void draw_arcs(const Panel& panel, const Edges& edges, Svg& svg) {
  for (std::size_t upper = 0; upper < panel.layers.size(); ++upper) {
    const std::set<std::string> targets = at(edges, std::string(panel.layers[upper].folder));
    for (std::size_t lower = 0; lower < upper; ++lower) {
      if (!targets.contains(std::string(panel.layers[lower].folder))) continue;
      const Point from = row_of(panel, upper);
      const Point to = row_of(panel, lower);
      const int bulge = std::min(12 + 7 * static_cast<int>(upper - lower), 60);
      svg.arc({from.x, from.y + 4}, {to.x, to.y - 4}, bulge);
    }
  }
}

void draw_panel(const Panel& panel, const Edges& edges, Svg& svg) {
  svg.box(panel.corner, panel.width, panel.height(), panel.fill, "#888");
  svg.text({panel.corner.x + 14, panel.corner.y + 25}, panel.title, "font-size=\"15\" font-weight=\"bold\"");
  draw_rows(panel, svg);
  draw_arcs(panel, edges, svg);
}

/// An arrow between two rooms: downwards within a column, to the right between columns.
void connect(const Panel& from, const Panel& to, Svg& svg) {
  if (from.corner.x == to.corner.x) {
    svg.arrow({from.right() - 30, from.bottom()}, {from.right() - 30, to.corner.y});
  } else {
    const int y = std::max(from.corner.y, to.corner.y) + kTitle / 2;
    svg.arrow({from.right(), y}, {to.corner.x, y});
  }
}

void draw_room_edges(const std::vector<Panel>& all, const Edges& edges, Svg& svg) {
  for (const Panel& from : all)
    for (const Panel& to : all)
      if (at(edges, std::string(from.room)).contains(std::string(to.room))) connect(from, to, svg);
}

std::string joined(const std::set<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

std::string table_row(const Layer& layer, const Edges& places, const Edges& libraries) {
  const std::string folder(layer.folder);
  return "| [" + folder + "](../" + folder + ") | " + std::string(layer.purpose) + " | " +
         joined(at(places, folder)) + " | " + joined(at(libraries, folder)) + " |\n";
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::string layers_svg(const IncludeGraph& graph) {
  const std::vector<Panel> all = panels();
  const int bottom = std::ranges::max(all, {}, &Panel::bottom).bottom();
  Svg svg(1220, bottom + 20);
  const Edges places = reduced(graph.places);
  for (const Panel& panel : all) draw_panel(panel, places, svg);
  draw_room_edges(all, reduced(graph.rooms), svg);
  svg.text({640, 40}, "An arrow leads from a folder to one that it includes. Where a chain of",
           "fill=\"#444\"");
  svg.text({640, 58}, "arrows leads there, too, the direct arrow is left out.", "fill=\"#444\"");
  svg.text({640, 76}, "A file includes its own folder and lower ones only.", "fill=\"#444\"");
  return svg.str();
}

std::string layer_tables(const IncludeGraph& graph) {
  const Edges places = reduced(graph.places);
  std::string out;
  for (const Panel& panel : panels()) {
    if (panel.layers.empty()) continue;
    out += "\n| " + std::string(panel.room) + " | holds | stands on | libraries |\n|---|---|---|---|\n";
    for (auto layer = panel.layers.rbegin(); layer != panel.layers.rend(); ++layer)
      out += table_row(*layer, places, graph.libraries);
  }
  return out + '\n';
}

std::string floor_lines() {
  std::string out = "\n";
  for (const Panel& panel : panels()) {
    if (panel.layers.empty()) continue;
    std::string names;
    for (const Layer& layer : panel.layers)
      names +=
          (names.empty() ? "" : " · ") + ("[" + short_name(layer) + "](") + std::string(layer.folder) + ")";
    out += "- **" + std::string(panel.room.substr(0, panel.room.size() - 1)) + "**: " + names + '\n';
  }
  return out + '\n';
}

std::string with_part(const std::string& text, const std::string& name, const std::string& content) {
  const std::string begin = "<!-- made: " + name + " -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = from == std::string::npos ? from : text.find("<!-- end -->", from);
  if (to == std::string::npos) throw std::runtime_error("there is no part '" + name + "' to replace");
  return text.substr(0, from + begin.size()) + content + text.substr(to);
}

std::map<std::filesystem::path, std::string> architecture_files(const std::filesystem::path& root) {
  const IncludeGraph graph = read_include_graph(root, source_files());
  return {{"docs/images/layers.svg", layers_svg(graph)},
          {"README.md", with_part(text_of(root / "README.md"), "floors", floor_lines())},
          {"docs/ARCHITECTURE.md",
           with_part(text_of(root / "docs/ARCHITECTURE.md"), "layers", layer_tables(graph))}};
}

}  // namespace kerf::house

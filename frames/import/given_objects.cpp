#include "frames/import/given_objects.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/whole_file.h"
#include "core/scene/shape.h"
#include "frames/support/csv_table.h"
#include "frames/support/errors.h"
#include "frames/support/utf8.h"

namespace kerf {
namespace {

/// Up to a # that begins a comment.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at < line.size() && line[at] != '#';
       at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// What a double cannot hold is a number, too.
bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && end == word.data() + word.size() && std::isfinite(value);
}

/// "3", "3/1", "3//2" or "3/1/2"
bool is_corner(std::string_view word) {
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view number = word.substr(0, slash);
    int value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (!(part > 0 && number.empty()) && (error != std::errc{} || end != number.data() + number.size()))
      return false;
    if (slash == word.size()) return true;
    word.remove_prefix(slash + 1);
  }
  return false;
}

/// What is wrong with a line; empty: nothing.
std::string complaint_about(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty()) return "";
  const bool is_long = words.size() > 3;
  if (words[0] == "v" && !(is_long && std::all_of(words.begin() + 1, words.end(), is_number)))
    return "is no vertex such as v 0 1.5 0: three numbers, with decimal points";
  if (words[0] == "f" && !(is_long && std::all_of(words.begin() + 1, words.end(), is_corner)))
    return "is no face such as f 1 2 3: the numbers of three vertices or more";
  return "";
}

/// The reader of OBJ takes 0 for what is no number, and passes over faces with too few corners.
void check_lines(std::string_view text, const std::filesystem::path& path) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view content = text.substr(0, end);
    if (const std::string complaint = complaint_about(content); !complaint.empty())
      throw UsageError(path.string() + ", line " + std::to_string(line) + ": '" + std::string(content) +
                       "' " + complaint);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
  }
}

tinyobj::ObjReader parse(const std::filesystem::path& path) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8
  std::string text = read_whole_file(path);
  if (text.starts_with(kMark)) text.erase(0, kMark.size());
  check_lines(text, path);
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, "", config)) throw UsageError(path.string() + ": " + reader.Error());
  return reader;
}

/// The triangles of a Wavefront OBJ file, larger faces divided. Throws UsageError for what is none.
std::shared_ptr<const Surface> read_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw UsageError("there is no file " + path.string());
  const tinyobj::ObjReader reader = parse(path);
  auto surface = std::make_shared<Surface>();
  const std::vector<tinyobj::real_t>& numbers = reader.GetAttrib().vertices;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) {
    surface->vertices.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    if (!is_finite(surface->vertices.back()))
      throw UsageError(path.string() + " has a vertex that is nowhere");
  }
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      auto& triangle = surface->triangles.emplace_back();
      for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
        const int vertex = corners[k + corner].vertex_index;
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= surface->vertices.size())
          throw UsageError(path.string() + " has a face without a vertex");
        triangle[corner] = static_cast<std::uint32_t>(vertex);
      }
    }
  }
  if (surface->triangles.empty()) throw UsageError(path.string() + " has no face");
  return surface;
}

struct Said {
  enum Column : std::size_t { object, name, color, shape, radius, half, points = half + 3, mesh };
};

std::vector<CsvColumn> said_columns() {
  return {{"object", {"id", "objectid", "body", "bodyid", "proxy", "handle", "entity", "uid"}},
          {"name", {"label", "title"}},
          {"color", {"colour", "rgb"}, true},
          {"shape", {"kind", "type"}},
          {"radius", {"r"}},
          {"half_x", {"hx", "halfwidth", "halfextentx"}},
          {"half_y", {"hy", "halfheight", "halfextenty"}},
          {"half_z", {"hz", "halfdepth", "halfextentz"}},
          {"points", {"vertices", "polygon", "corners"}},
          {"mesh", {"obj", "meshfile"}}};
}

Scalar read_length(const CsvTable& table, std::size_t column, const std::string& of) {
  if (table.is_blank(column)) table.reject(of + " needs " + said_columns()[column].name + ", a length");
  const double length = table.real(column);
  const auto as_float = static_cast<Scalar>(length);
  if (!std::isfinite(length) || length <= 0) table.reject(column, "is no length: it must be above 0");
  if (!std::isfinite(as_float) || as_float == 0)
    table.reject(column, "is a length that no float holds: they end at 1.4e-45 and 3.4e38");
  return as_float;
}

template <int D>
Brick<D> read_brick(const CsvTable& table) {
  Brick<D> brick;
  for (std::size_t axis = 0; axis < D; ++axis)
    brick.half.value[axis] = read_length(table, Said::half + axis, "a brick");
  return brick;
}

/// "x y; x y; x y"
std::vector<Vector<2>> read_points(const CsvTable& table) {
  if (table.is_blank(Said::points)) table.reject("a polygon needs points, such as 0 0; 1 0; 0 1");
  std::vector<Scalar> numbers;
  std::string text(table.text(Said::points));
  std::ranges::replace_if(
      text, [](char c) { return c == ';' || c == ',' || c == '\t'; }, ' ');
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (end > 0) {
      Scalar number = 0;
      const auto [stop, error] = std::from_chars(rest.data(), rest.data() + end, number);
      if (error != std::errc{} || stop != rest.data() + end || !std::isfinite(number))
        table.reject(Said::points, "is no list of points such as 0 0; 1 0; 0 1");
      numbers.push_back(number);
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  std::vector<Vector<2>> points;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) points.push_back({numbers[k], numbers[k + 1]});
  if (numbers.size() % 2 != 0 || points.size() < 3)
    table.reject(Said::points, "has no three points such as 0 0; 1 0; 0 1");
  return points;
}

/// Whether all corners turn left, and the outline goes around once.
bool is_convex(const std::vector<Vector<2>>& corners) {
  constexpr double kOnce = 7;  // more than a turn in radians, less than two
  double turned = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector<2> to = corners[(k + 1) % corners.size()] - corners[k];
    const Vector<2> next = corners[(k + 2) % corners.size()] - corners[(k + 1) % corners.size()];
    const double cross = double{to[0]} * next[1] - double{to[1]} * next[0];
    if (!(cross > 0)) return false;
    turned += std::atan2(cross, double{to[0]} * next[0] + double{to[1]} * next[1]);
  }
  return turned < kOnce;
}

Outline read_outline(const CsvTable& table) {
  Outline outline{read_points(table)};
  if (!is_convex(outline.corners)) std::ranges::reverse(outline.corners);
  if (!is_convex(outline.corners))
    table.reject(Said::points, "is not convex, or has points that lie on a line");
  return outline;
}

std::shared_ptr<const Surface> read_surface(const CsvTable& table, const std::filesystem::path& folder) {
  if (table.is_blank(Said::mesh)) table.reject("a mesh needs mesh, the path of an OBJ file");
  try {
    return read_mesh(folder / std::string(table.text(Said::mesh)));
  } catch (const UsageError& error) {
    table.reject(Said::mesh, std::string("is no mesh: ") + error.what());
  }
}

/// A measure that the shape does not have would be passed over.
void check_measures(const CsvTable& table, const std::string& shape, std::size_t first, std::size_t count) {
  for (std::size_t column = Said::radius; column <= Said::mesh; ++column)
    if ((column < first || column >= first + count) && !table.is_blank(column))
      table.reject(column, shape.empty() ? "is of an object without a shape; say one, such as ball"
                                         : "is no measure of a " + shape + "; leave it blank");
}

template <int D>
std::optional<Shape<D>> read_shape(const CsvTable& table, const std::filesystem::path& folder) {
  if (table.is_blank(Said::shape)) {
    check_measures(table, "", 0, 0);
    return std::nullopt;
  }
  std::string kind(table.text(Said::shape));
  std::ranges::transform(kind, kind.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, kind) != names.end();
  };
  const auto has_only = [&](std::size_t first, std::size_t count) {
    check_measures(table, kind, first, count);
    return true;
  };
  if (is({"ball", "sphere", "disc", "disk", "circle"}) && has_only(Said::radius, 1))
    return Ball{read_length(table, Said::radius, "a " + kind)};
  if (is({"brick", "box", "cuboid", "rectangle", "cube"}) && has_only(Said::half, 3))
    return read_brick<D>(table);
  if constexpr (D == 2) {
    if (is({"polygon", "outline"}) && has_only(Said::points, 1)) return read_outline(table);
  } else {
    if (is({"mesh", "surface"}) && has_only(Said::mesh, 1)) return read_surface(table, folder);
  }
  table.reject(Said::shape,
               std::string("is no shape; there are ball, brick and ") + (D == 2 ? "polygon" : "mesh"));
}

ObjectMark read_mark(const CsvTable& table) {
  ObjectMark mark{valid_utf8(std::string(table.text(Said::name))), std::nullopt};
  if (!is_label(mark.label))
    table.reject(Said::name, "is too long for a name, or has characters that cannot be shown");
  if (table.is_blank(Said::color)) return mark;
  mark.color = parse_rgb(table.text(Said::color));
  if (!mark.color) table.reject(Said::color, "is no colour such as #1f77b4");
  return mark;
}

}  // namespace

template <int D>
std::vector<GivenObject<D>> read_given_objects(const std::filesystem::path& path, Oddities& oddities) {
  CsvTable table(path, said_columns());
  if (!table.has_heading() || !table.has(Said::object))
    throw UsageError(table.name() +
                     ": a table of objects needs a heading with object, and any of name, color, shape, "
                     "radius, half_x, half_y, half_z, points, mesh");
  std::vector<GivenObject<D>> objects;
  std::set<GivenId> known;
  while (table.next()) {
    GivenObject<D> given{table.id(Said::object), table.line(), read_mark(table),
                         read_shape<D>(table, path.parent_path())};
    if (!known.insert(given.object).second)
      table.reject("object " + to_string(given.object) + " stands twice");
    objects.push_back(std::move(given));
  }
  note_cut(table, oddities);
  return objects;
}

template std::vector<GivenObject<2>> read_given_objects<2>(const std::filesystem::path&, Oddities&);
template std::vector<GivenObject<3>> read_given_objects<3>(const std::filesystem::path&, Oddities&);

}  // namespace kerf

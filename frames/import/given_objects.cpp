#include "frames/import/given_objects.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "frames/import/given_mesh.h"
#include "frames/support/csv_table.h"
#include "frames/support/errors.h"
#include "frames/support/utf8.h"

namespace kerf {
namespace {

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

#include "viz/draw/structure_draw.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "viz/draw/clip.h"
#include "viz/draw/pair_density.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

// From dark to light, so that depth is seen without hue, too.
constexpr std::array<Color, 4> kDepths{{{45, 20, 95}, {105, 50, 165}, {165, 105, 215}, {215, 175, 240}}};

double depth_share(std::uint32_t depth) { return std::min(1.0, double{1} * depth / kDeepCell); }

Polygon rectangle(const Box<2>& box) {
  return {{box.min[0], box.min[1], 0},
          {box.max[0], box.min[1], 0},
          {box.max[0], box.max[1], 0},
          {box.min[0], box.max[1], 0}};
}

constexpr int kRound = 48;  // corners that stand for a circle

/// The circle in a square.
Polygon circle(const Box<2>& box) {
  const Eigen::Vector3d middle = to_point(box.center());
  const Vector<2> extent = box.extent();
  Polygon polygon;
  for (int k = 0; k < kRound; ++k) {
    const double angle = 2 * std::numbers::pi * k / kRound;
    polygon.emplace_back(
        middle + Eigen::Vector3d(0.5 * extent[0] * std::cos(angle), 0.5 * extent[1] * std::sin(angle), 0));
  }
  return polygon;
}

/// The sides of planes on which a cell lies.
template <int D>
std::vector<HalfSpace> sides_of(const StructureParts<D>& parts, std::uint32_t cell) {
  std::vector<HalfSpace> sides;
  for (; cell != kNoPart; cell = parts.cells[cell].parent) {
    if (parts.cells[cell].cut == kNoPart) continue;
    const Cut<D>& cut = parts.cuts[parts.cells[cell].cut];
    sides.push_back(half_space(cut.plane, cut.right));
  }
  return sides;
}

template <int D>
std::vector<std::uint32_t> population_of(const StructureParts<D>& parts) {
  std::vector<std::uint32_t> population(parts.cells.size(), 0);
  for (const CellMember& member : parts.members) ++population[member.cell];
  return population;
}

template <int D>
double line_width(const StructureParts<D>& parts, std::uint32_t depth) {
  const bool are_nested =
      std::ranges::any_of(parts.cells, [](const auto& cell) { return cell.parent != kNoPart; });
  return are_nested ? 2.4 - 1.6 * depth_share(depth) : 1.2;
}

/// What a cell covers in the plane.
Polygon area_of(const StructureParts<2>& parts, std::uint32_t cell, const Box<2>& bounds) {
  const Box<2> box = with_ends(parts.cells[cell].box, bounds);
  Polygon polygon = parts.is_round ? circle(box) : rectangle(box);
  clip(polygon, sides_of(parts, cell));
  return polygon;
}

/// The part of a convex polygon in another one, whose corners stand counter-clockwise.
Polygon common_part(Polygon polygon, const Polygon& other) {
  for (std::size_t k = 0; k < other.size() && !polygon.empty(); ++k) {
    const Eigen::Vector3d& from = other[k];
    const Eigen::Vector3d along = other[(k + 1) % other.size()] - from;
    const Eigen::Vector3d normal(along.y(), -along.x(), 0);
    clip(polygon, HalfSpace{normal, normal.dot(from)});
  }
  return polygon;
}

void outline_box(const DrawContext<2>& context, const Box<2>& box, const Stroke& stroke, Batch& batch) {
  add_outline(batch, context.view, rectangle(box), stroke);
}

void outline_ball(const DrawContext<2>& context, const Box<2>& box, const Stroke& stroke, Batch& batch) {
  add_outline(batch, context.view, circle(box), stroke);
}

/// As it is seen: a circle across the sight. Others would be lost among those of its neighbours.
void outline_ball(const DrawContext<3>& context, const Box<3>& box, const Stroke& stroke, Batch& batch) {
  const Eigen::Vector3d middle = to_point(box.center());
  const double radius = 0.5 * box.extent()[0];
  const Eigen::Vector3d across = context.view.forward.unitOrthogonal() * radius;
  const Eigen::Vector3d up = context.view.forward.normalized().cross(across);
  Polygon polygon;
  for (int k = 0; k < kRound; ++k) {
    const double angle = 2 * std::numbers::pi * k / kRound;
    polygon.emplace_back(middle + std::cos(angle) * across + std::sin(angle) * up);
  }
  add_outline(batch, context.view, polygon, stroke);
}

void outline_box(const DrawContext<3>& context, const Box<3>& box, const Stroke& stroke, Batch& batch) {
  const auto corner = [&](unsigned bits) {
    return Eigen::Vector3d((bits & 1U) != 0 ? box.max[0] : box.min[0],
                           (bits & 2U) != 0 ? box.max[1] : box.min[1],
                           (bits & 4U) != 0 ? box.max[2] : box.min[2]);
  };
  for (unsigned bits = 0; bits < 8; ++bits)
    for (const unsigned axis : {1U, 2U, 4U})
      if ((bits & axis) == 0) add_line(batch, context.view, corner(bits), corner(bits | axis), stroke);
}

/// The plane that divides a cell from its sibling, in their parent. Drawn with the left one.
template <int D>
void draw_cut(const DrawContext<D>& context, const StructureParts<D>& parts, std::uint32_t cell,
              const Stroke& stroke, Batch& batch) {
  const Cut<D>& cut = parts.cuts[parts.cells[cell].cut];
  if (cut.right) return;
  const Polygon polygon =
      plane_within(half_space(cut.plane, false), context.bounds, sides_of(parts, parts.cells[cell].parent));
  if (polygon.empty()) return;
  if constexpr (D == 3) add_polygon(batch, context.view, polygon, with_alpha(stroke.color, 0.05));
  add_outline(batch, context.view, polygon, stroke);
}

}  // namespace

Color depth_color(std::uint32_t depth) {
  const double place = depth_share(depth) * (kDepths.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kDepths.size() - 2);
  return mix(kDepths[low], kDepths[low + 1], place - static_cast<double>(low));
}

Color fill_color(std::uint32_t objects) {
  constexpr double kSteps = 1000;
  const double share = std::log2(std::max(1.0, double{1} * objects)) / std::log2(double{kFullCell});
  return palette::population_color(static_cast<std::uint32_t>(kSteps * std::min(1.0, share) + 0.5),
                                   static_cast<std::uint32_t>(kSteps));
}

template <int D>
std::vector<Color> object_colors(const StructureParts<D>& parts, std::span<const Body<D>> bodies) {
  struct Place {
    std::uint32_t cells = 0;
    std::uint32_t most = 0;
  };
  const std::vector<std::uint32_t> population = population_of(parts);
  std::vector<Place> places(bodies.size());
  for (const CellMember& member : parts.members) {
    if (member.object.index() >= places.size()) continue;
    Place& place = places[member.object.index()];
    ++place.cells;
    place.most = std::max(place.most, population[member.cell]);
  }
  std::vector<Color> colors(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    colors[k] = own_color(bodies[k].mobility, bodies[k].color);
    if (bodies[k].mobility == Mobility::fixed) continue;
    if (places[k].cells > 1) {
      colors[k] = palette::kStraddler;
    } else if (D == 3 && places[k].most > 1) {
      colors[k] = fill_color(places[k].most);
    }
  }
  return colors;
}

void draw_cell_areas(const DrawContext<2>& context, const StructureParts<2>& parts, Batch& batch) {
  constexpr double kApart = 0.5;     // cells that share nothing
  constexpr double kNested = 0.2;    // others shine through
  constexpr double kOverlap = 0.09;  // adds up from level to level
  const double alpha = parts.holding == Holding::reaching ? kApart : kNested;
  const std::vector<std::uint32_t> population = population_of(parts);
  for (std::uint32_t cell = 0; cell < parts.cells.size(); ++cell) {
    if (population[cell] == 0) continue;
    context.begin(batch, DrawnKind::leaf, parts.cells[cell].name);
    add_polygon(batch, context.view, area_of(parts, cell, context.bounds),
                with_alpha(fill_color(population[cell]), alpha));
  }
  for (const std::vector<std::uint32_t>& siblings : children_of(parts)) {
    // Of more than two siblings there are more pairs, whose areas would hide all else.
    const double count = static_cast<double>(siblings.size());
    const double strength = kOverlap / std::sqrt(std::max(1.0, 0.5 * count * (count - 1)));
    for (std::size_t i = 0; i < siblings.size(); ++i)
      for (std::size_t k = i + 1; k < siblings.size(); ++k) {
        if (!(overlap_share(parts, siblings[i], siblings[k], context.bounds) > 0)) continue;
        add_polygon(batch, context.view,
                    common_part(area_of(parts, siblings[i], context.bounds),
                                area_of(parts, siblings[k], context.bounds)),
                    with_alpha(kSiblingOverlap, strength));
      }
  }
}

/// The deepest first, so that what is large lies above.
template <int D>
void draw_cell_outlines(const DrawContext<D>& context, const StructureParts<D>& parts, Batch& batch) {
  std::vector<std::uint32_t> order(parts.cells.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t k) { return parts.cells[k].depth; });
  for (const std::uint32_t cell : order) {
    const StructureCell<D>& told = parts.cells[cell];
    if (told.parent == kNoPart && !parts.cuts.empty()) continue;  // all of space
    // A plane is as old as the parent that it divides.
    const std::uint32_t depth = told.cut == kNoPart ? told.depth : told.depth - 1;
    const double alpha = D == 2 ? 1 : 0.85 - 0.4 * depth_share(depth);
    const Stroke stroke{with_alpha(depth_color(depth), alpha), line_width(parts, depth) * context.line_scale};
    context.begin(batch, told.cut == kNoPart ? DrawnKind::leaf : DrawnKind::plane, told.name);
    if (told.cut != kNoPart) {
      draw_cut(context, parts, cell, stroke, batch);
    } else if (parts.is_round) {
      outline_ball(context, told.box, stroke, batch);
    } else {
      outline_box(context, with_ends(told.box, context.bounds), stroke, batch);
    }
  }
}

template <int D>
void draw_rejected(const DrawContext<D>& context, std::span<const Pair> rejected, Batch& batch) {
  struct Seen {
    Eigen::Vector3d a, b;
    std::optional<Eigen::Vector2d> middle;
  };
  constexpr double kOpacity = 0.7;
  constexpr double kLeast = 0.06;
  const double width = 0.9 * context.line_scale;
  const auto bodies = context.input.bodies;
  std::vector<Seen> all;
  PairDensity density(context.view);
  for (const Pair& pair : rejected) {
    if (pair.a.index() >= bodies.size() || pair.b.index() >= bodies.size()) continue;
    const Body<D>& a = bodies[pair.a.index()];
    const Body<D>& b = bodies[pair.b.index()];
    if (!is_drawable(a) || !is_drawable(b)) continue;
    const auto [from, to] = pair_line(context.view, a, b);
    const Eigen::Vector3d middle = 0.5 * (from + to);
    all.push_back({from, to, context.view.project(middle)});
    if (all.back().middle)
      density.add(*all.back().middle, (to - from).norm() * context.view.pixels_per_unit(middle) * width);
  }
  batch.item = 0;
  for (const Seen& seen : all) {
    const double strength = seen.middle ? density.strength(*seen.middle) : 1;
    add_line(batch, context.view, seen.a, seen.b,
             {with_alpha(kRejectedTest, std::max(kLeast, kOpacity * strength)), width});
  }
}

#define KERF_INSTANTIATE(D)                                                                      \
  template std::vector<Color> object_colors(const StructureParts<D>&, std::span<const Body<D>>); \
  template void draw_cell_outlines(const DrawContext<D>&, const StructureParts<D>&, Batch&);     \
  template void draw_rejected(const DrawContext<D>&, std::span<const Pair>, Batch&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

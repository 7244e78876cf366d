#include "viz/draw/wrong_pair_lines.h"

#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kErrorLine = 2.5;  // pixels, and its edges
constexpr double kErrorEdge = 5;
constexpr double kErrorDiamond = 6;

/// The line can be as short as a point: the diamond in its middle is seen all the same.
template <int D>
void draw_wrong_pair(const DrawContext<D>& frame, const WrongPairLines<D>& wrong, const Pair& pair,
                     Color color, Batch& batch) {
  const auto [a, b] = pair_line<D>(frame.view, wrong.bodies[pair.a.index()], wrong.bodies[pair.b.index()]);
  const double scale = frame.line_scale;
  const Eigen::Vector3d middle = 0.5 * (a + b);
  frame.begin(batch, DrawnKind::pair, pair.a.value, pair.b.value);
  add_line(batch, frame.view, a, b, {palette::kInk, kErrorEdge * scale});
  add_diamond(batch, frame.view, middle, (kErrorDiamond + 2) * scale, palette::kInk);
  add_line(batch, frame.view, a, b, {color, kErrorLine * scale});
  add_diamond(batch, frame.view, middle, kErrorDiamond * scale, color);
}

}  // namespace

template <int D>
std::vector<Pair> drawable_pairs(std::span<const Pair> pairs, std::span<const Body<D>> bodies,
                                 std::span<const std::uint8_t> shown, std::size_t most) {
  const auto is_shown = [&](ObjectId object) {
    return object.index() < bodies.size() && (shown.empty() || shown[object.index()] != 0) &&
           is_drawable(bodies[object.index()]);
  };
  std::vector<Pair> drawable;
  for (const Pair& pair : pairs)
    if (drawable.size() < most && is_shown(pair.a) && is_shown(pair.b)) drawable.push_back(pair);
  return drawable;
}

template <int D>
void draw_wrong_pairs(const DrawContext<D>& frame, const WrongPairLines<D>& wrong, Batch& batch) {
  for (const Pair& pair : wrong.extra) draw_wrong_pair(frame, wrong, pair, palette::kExtra, batch);
  for (const Pair& pair : wrong.missed) draw_wrong_pair(frame, wrong, pair, palette::kMissed, batch);
}

template std::vector<Pair> drawable_pairs<2>(std::span<const Pair>, std::span<const Body<2>>,
                                             std::span<const std::uint8_t>, std::size_t);
template std::vector<Pair> drawable_pairs<3>(std::span<const Pair>, std::span<const Body<3>>,
                                             std::span<const std::uint8_t>, std::size_t);
template void draw_wrong_pairs<2>(const DrawContext<2>&, const WrongPairLines<2>&, Batch&);
template void draw_wrong_pairs<3>(const DrawContext<3>&, const WrongPairLines<3>&, Batch&);

}  // namespace kerf

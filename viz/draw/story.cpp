#include "viz/draw/story.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "viz/draw/icicle.h"
#include "viz/draw/letters.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kRightPart = 0.34;  ///< of the width
constexpr Color kInnerNode{214, 214, 208};
constexpr Color kGrid{222, 222, 216};

/// One picture's margins, as rectangles.
struct StoryPlaces {
  Viewport title;
  Viewport sentence;
  Viewport icicle;
  Viewport plot;
};

StoryPlaces places_of(const View& view, const Font& font) {
  const int pad = font.line_height() / 2;
  const auto width = static_cast<int>(view.picture_width);
  const auto height = static_cast<int>(view.picture_height);
  const Margins margins = story_margins(width, height);
  const double left = width - margins.right + pad;
  const double inner = margins.right - 2.0 * pad;
  const double middle = 0.46 * height;
  StoryPlaces places;
  places.title = {double(pad), double(pad), double(width - margins.right), double(font.line_height())};
  places.sentence = {double(pad), double(height - margins.bottom + pad),
                     double(width - margins.right - 2 * pad), double(margins.bottom - pad)};
  places.icicle = {left, double(pad), inner, middle - 2.0 * pad};
  places.plot = {left, middle, inner, height - middle - pad};
  return places;
}

/// As much of the text as has room in so many lines, in whole words; the last line says that there is more.
std::vector<std::string> wrapped(const Font& font, const std::string& text, double width, int most) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t space = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, space - begin);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (font.width(longer) > width && !lines.back().empty())
      lines.push_back(word);
    else
      lines.back() = longer;
    begin = space + 1;
  }
  const auto room = static_cast<std::size_t>(std::max(1, most));
  if (lines.size() > room) {
    lines.resize(room);
    lines.back() += " ...";
  }
  for (std::string& line : lines) line = shortened(line, font.letters(static_cast<int>(width)));
  return lines;
}

void draw_words(const Font& font, const StoryPlaces& places, const StoryPanels& panels, Overlay& overlay) {
  const int x = static_cast<int>(places.title.left);
  const int y = static_cast<int>(places.title.top);
  const int right = static_cast<int>(places.title.width);
  const std::string title = shortened(panels.title, font.letters(right - x));
  const int behind = x + font.width(title + "  ");
  overlay.text.add(font, x, y, title, palette::kInk);
  overlay.text.add(font, behind, y, shortened(panels.figures, font.letters(right - behind)),
                   palette::kFaintInk);
  int line = static_cast<int>(places.sentence.top);
  const int lines = static_cast<int>(places.sentence.height) / font.line_height();
  for (const std::string& words : wrapped(font, panels.sentence, places.sentence.width, lines)) {
    overlay.text.add(font, x, line, words, palette::kInk);
    line += font.line_height();
  }
}

void draw_rim(const View& view, const Viewport& r, Color color, double width, Overlay& overlay) {
  const Eigen::Vector2d a(r.left, r.top);
  const Eigen::Vector2d b(r.left + r.width, r.top);
  const Eigen::Vector2d c(r.left + r.width, r.top + r.height);
  const Eigen::Vector2d d(r.left, r.top + r.height);
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
    add_line_on_picture(overlay.shapes, view, from, to, {color, width});
}

/// A third of a pixel between neighbours, so that many narrow leaves keep their colours.
Viewport bar_place(const Viewport& place, const IcicleBar& bar, double row) {
  const double gap = std::min(1.0, 0.2 * (bar.right - bar.left) * place.width);
  return {place.left + bar.left * place.width, place.top + bar.depth * row,
          (bar.right - bar.left) * place.width - gap, row - 1};
}

void draw_icicle(const View& view, const Font& font, const Viewport& place, const StoryPanels& panels,
                 Overlay& overlay) {
  const TreeSnapshot& tree = *panels.tree;
  const int line = font.line_height();
  overlay.text.add(font, static_cast<int>(place.left), static_cast<int>(place.top),
                   "The tree: " + with_commas(tree.leaves()) + (tree.leaves() == 1 ? " leaf" : " leaves"),
                   palette::kInk);
  const Viewport bars{place.left, place.top + 1.4 * line, place.width, place.height - 1.4 * line};
  const double row = std::min(1.4 * line, bars.height / std::max(1U, panels.levels));
  std::optional<Viewport> acting;
  for (const IcicleBar& bar : icicle_bars(tree)) {
    if ((bar.depth + 1) * row > bars.height + 0.5) continue;
    const TreeSnapshot::Node& node = tree[bar.node];
    const Color color =
        node.is_leaf() ? palette::population_color(node.population, panels.largest_population) : kInnerNode;
    const Viewport rectangle = bar_place(bars, bar, row);
    add_rectangle_on_picture(overlay.shapes, view, rectangle, color);
    if (panels.acting == bar.node) acting = rectangle;
  }
  if (acting) draw_rim(view, *acting, palette::kOperator, 0.14 * line, overlay);
}

/// From values to pixels: steps to the right, powers of ten upwards. If there is a 0, it has a line of its
/// own at the bottom, as far below the lowest power as that is below the next.
class StoryScale {
 public:
  StoryScale(const Viewport& place, const std::vector<StoryCurve>& curves) : place_(place) {
    double most = 10;
    double least = std::numeric_limits<double>::infinity();
    for (const StoryCurve& curve : curves) {
      steps_ = std::max(steps_, curve.values.size());
      for (const float value : curve.values) {
        has_zero_ |= value >= 0 && value < 1;
        if (value < 1) continue;
        most = std::max(most, double{value});
        least = std::min(least, double{value});
      }
    }
    low_ = std::floor(std::log10(std::min(least, most)));
    high_ = std::max(low_ + 1, std::ceil(std::log10(most)));
  }
  [[nodiscard]] double x(std::size_t step) const {
    return place_.left +
           place_.width * static_cast<double>(step) / static_cast<double>(std::max<std::size_t>(1, steps_));
  }
  [[nodiscard]] double y(double value) const {
    const double bottom = has_zero_ ? low_ - 1 : low_;
    const double part = value < 1 ? 0 : (std::log10(value) - bottom) / (high_ - bottom);
    return place_.top + place_.height * (1 - std::clamp(part, 0.0, 1.0));
  }
  [[nodiscard]] bool has_zero() const { return has_zero_; }
  [[nodiscard]] int low() const { return static_cast<int>(low_); }
  [[nodiscard]] int high() const { return static_cast<int>(high_); }

 private:
  Viewport place_;
  std::size_t steps_ = 1;
  bool has_zero_ = false;
  double low_ = 0;
  double high_ = 1;
};

std::string power_of_ten(int exponent) {
  constexpr std::array<const char*, 10> kNames{"1",    "10", "100", "1k",   "10k",
                                               "100k", "1M", "10M", "100M", "1G"};
  return exponent < static_cast<int>(kNames.size()) ? kNames[static_cast<std::size_t>(exponent)]
                                                    : "1e" + std::to_string(exponent);
}

void draw_grid(const View& view, const Font& font, const Viewport& place, const StoryScale& scale,
               Overlay& overlay) {
  const auto add = [&](double y, const std::string& name) {
    add_line_on_picture(overlay.shapes, view, {place.left, y}, {place.left + place.width, y}, {kGrid, 1.5});
    overlay.text.add(font, static_cast<int>(place.left) - font.width(name + " "),
                     static_cast<int>(y) - font.line_height() / 2, name, palette::kFaintInk);
  };
  if (scale.has_zero()) add(scale.y(0), "0");
  for (int power = scale.low(); power <= scale.high(); ++power)
    add(scale.y(std::pow(10.0, power)), power_of_ten(power));
}

void draw_steps(const Font& font, const Viewport& place, const std::array<std::string, 2>& ends,
                Overlay& overlay) {
  const int y = static_cast<int>(place.top + place.height) + font.line_height() / 3;
  const auto left = static_cast<int>(place.left);
  const auto right = static_cast<int>(place.left + place.width);
  overlay.text.add(font, left, y, "step " + ends[0], palette::kFaintInk);
  overlay.text.add(font, right - font.width(ends[1]), y, ends[1], palette::kFaintInk);
}

void draw_story_curve(const View& view, const StoryScale& scale, const StoryCurve& curve, std::uint32_t step,
                      double width, Overlay& overlay) {
  const std::size_t end = std::min<std::size_t>(step, curve.values.size());
  std::optional<Eigen::Vector2d> last;
  for (std::size_t k = 0; k < end; ++k) {
    if (curve.values[k] < 0) continue;
    const Eigen::Vector2d now(scale.x(k + 1), scale.y(curve.values[k]));
    if (last && (now - *last).norm() < 1.5 && k + 1 < end) continue;
    if (last) add_line_on_picture(overlay.shapes, view, *last, now, {curve.color, width});
    last = now;
  }
  if (last) add_diamond_on_picture(overlay.shapes, view, *last, 2.2 * width, curve.color);
}

/// The value of a curve at a step, or the last one before.
std::optional<float> value_at(const StoryCurve& curve, std::uint32_t step) {
  for (std::size_t k = std::min<std::size_t>(step, curve.values.size()); k > 0; --k)
    if (curve.values[k - 1] >= 0) return curve.values[k - 1];
  return std::nullopt;
}

void draw_curves(const View& view, const Font& font, const Viewport& place, const StoryPanels& panels,
                 Overlay& overlay) {
  const int line = font.line_height();
  int y = static_cast<int>(place.top);
  const auto left = static_cast<int>(place.left);
  const char* const heading = "Tests of box against box, this step";
  const bool has_room = font.width(heading) <= static_cast<int>(place.width);
  overlay.text.add(font, left, y, has_room ? heading : "Box tests, this step", palette::kInk);
  const int indent = 2 * font.advance();
  for (const StoryCurve& curve : *panels.curves) {
    y += line;
    add_rectangle_on_picture(overlay.shapes, view,
                             {place.left, y + 0.4 * line, 1.4 * font.advance(), 0.25 * line}, curve.color);
    const auto value = value_at(curve, panels.step);
    const std::string number = value ? with_commas(static_cast<std::uint64_t>(*value)) : "";
    const int room = static_cast<int>(place.width) - indent - font.width(number + " ");
    overlay.text.add(font, left + indent, y, shortened(curve.name, font.letters(room)), palette::kInk);
    overlay.text.add(font, left + static_cast<int>(place.width) - font.width(number), y, number,
                     palette::kInk);
  }
  const double axis = font.width("100M ");
  const double top = y + 1.7 * line;
  const Viewport inner{place.left + axis, top, place.width - axis - 0.5 * line,
                       place.top + place.height - top - 1.5 * line};
  const StoryScale scale(inner, *panels.curves);
  draw_grid(view, font, inner, scale, overlay);
  draw_steps(font, inner, panels.ends, overlay);
  for (const StoryCurve& curve : *panels.curves)
    draw_story_curve(view, scale, curve, panels.step, 0.12 * line, overlay);
}

}  // namespace

/// The panel at the right is a share of the width: letters by the height alone would leave it in upright
/// pictures.
int story_letters(int width, int height) { return font_pixels(std::min(height, width * 9 / 16)); }

Margins story_margins(int width, int height) {
  const int line = story_letters(width, height) * 5 / 4;
  return {0, 2 * line, static_cast<int>(kRightPart * width), 3 * line};
}

void draw_story(const View& view, const Font& font, const StoryPanels& panels, Overlay& overlay) {
  const auto width = static_cast<int>(view.picture_width);
  const Margins margins = story_margins(width, static_cast<int>(view.picture_height));
  add_rectangle_on_picture(overlay.shapes, view,
                           {double(width - margins.right), 0, double(margins.right), view.picture_height},
                           palette::kPanel);
  const StoryPlaces places = places_of(view, font);
  draw_words(font, places, panels, overlay);
  if (panels.tree != nullptr) draw_icicle(view, font, places.icicle, panels, overlay);
  if (panels.curves != nullptr) draw_curves(view, font, places.plot, panels, overlay);
}

std::string with_commas(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, ",");
  return text;
}

}  // namespace kerf

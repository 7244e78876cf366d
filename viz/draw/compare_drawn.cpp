#include "viz/draw/compare_drawn.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <tuple>

#include "core/base/counted.h"

namespace kerf {
namespace {

/// Bounds are computed before rasterising; files have them rounded to hundredths.
constexpr float kSamePlace = 0.05F;
/// Every rasteriser shows an item of so many pixels.
constexpr std::uint32_t kClearlySeen = 6;

/// What an item means, and the how manyth with that meaning it is: a leaf may have a face and an outline.
using Key = std::tuple<DrawnKind, std::uint32_t, std::uint32_t, std::uint32_t>;

bool is_drawn(const Drawn& drawn) { return drawn.right >= drawn.left; }

std::vector<Key> keys_of(const DrawList& list) {
  std::vector<Key> keys;
  keys.reserve(list.items.size());
  std::map<std::tuple<DrawnKind, std::uint32_t, std::uint32_t>, std::uint32_t> earlier;
  for (const Drawn& drawn : list.items)
    keys.emplace_back(drawn.kind, drawn.a, drawn.b, earlier[{drawn.kind, drawn.a, drawn.b}]++);
  return keys;
}

/// The items that are drawn.
std::map<Key, std::uint32_t> index_of(const DrawList& list) {
  std::map<Key, std::uint32_t> index;
  const std::vector<Key> keys = keys_of(list);
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    if (is_drawn(list.items[i])) index.emplace(keys[i], i + 1);
  return index;
}

std::string color_text(Color c) {
  char text[16];
  std::snprintf(text, sizeof text, c.a == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x", c.r, c.g, c.b, c.a);
  return text;
}

std::string shift_text(const Drawn& a, const Drawn& b) {
  const auto near = [](float x, float y) { return std::abs(x - y) < kSamePlace; };
  const float dx = b.left - a.left;
  const float dy = b.top - a.top;
  char text[160];
  if (near(dx, b.right - a.right) && near(dy, b.bottom - a.bottom)) {
    std::snprintf(text, sizeof text, " moved by (%.1f, %.1f) pixels", double{dx}, double{dy});
  } else {
    std::snprintf(text, sizeof text,
                  " spans (%.1f, %.1f) to (%.1f, %.1f) and not (%.1f, %.1f) to (%.1f, %.1f)", double{b.left},
                  double{b.top}, double{b.right}, double{b.bottom}, double{a.left}, double{a.top},
                  double{a.right}, double{a.bottom});
  }
  return text;
}

bool same_place(const Drawn& a, const Drawn& b) {
  return std::abs(a.left - b.left) <= kSamePlace && std::abs(a.top - b.top) <= kSamePlace &&
         std::abs(a.right - b.right) <= kSamePlace && std::abs(a.bottom - b.bottom) <= kSamePlace;
}

/// Id images in the numbers of the reference; items that it does not have come after its own.
struct Ids {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> reference;
  std::vector<std::uint32_t> test;
};

std::vector<std::uint32_t> numbers_of(const Image& image, const std::vector<std::uint32_t>& number) {
  std::vector<std::uint32_t> result;
  result.reserve(image.rgba.size() / 4);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint32_t item = item_of(image.rgba.data() + i);
    result.push_back(item < number.size() ? number[item] : 0);
  }
  return result;
}

Ids align(const FrameIds& reference, const FrameIds& test) {
  if (reference.image.width != test.image.width || reference.image.height != test.image.height)
    throw std::invalid_argument("id images of different sizes cannot be compared");
  const std::map<Key, std::uint32_t> known = index_of(reference.list);
  auto next = static_cast<std::uint32_t>(reference.list.items.size() + 1);
  std::vector<std::uint32_t> own(reference.list.items.size() + 1);
  for (std::uint32_t i = 0; i < own.size(); ++i) own[i] = i;
  std::vector<std::uint32_t> other{0};
  for (const Key& key : keys_of(test.list)) {
    const auto same = known.find(key);
    other.push_back(same == known.end() ? next++ : same->second);
  }
  return {reference.image.width, reference.image.height, numbers_of(reference.image, own),
          numbers_of(test.image, other)};
}

/// Whether `item` covers a pixel or one beside it.
bool is_near(const Ids& ids, const std::vector<std::uint32_t>& numbers, int x, int y, std::uint32_t item) {
  for (int v = std::max(0, y - 1); v <= std::min(ids.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(ids.width - 1, x + 1); ++u)
      if (numbers[static_cast<std::size_t>(v * ids.width + u)] == item) return true;
  return false;
}

/// For each item of the reference the number of pixels from which it is gone.
std::map<std::uint32_t, std::uint32_t> count_gone(const Ids& ids, const std::vector<std::uint32_t>& from,
                                                  const std::vector<std::uint32_t>& to) {
  std::map<std::uint32_t, std::uint32_t> gone;
  for (int y = 0; y < ids.height; ++y) {
    for (int x = 0; x < ids.width; ++x) {
      const std::uint32_t item = from[static_cast<std::size_t>(y * ids.width + x)];
      if (item != 0 && !is_near(ids, to, x, y, item)) ++gone[item];
    }
  }
  return gone;
}

/// Collects findings, the gravest first.
class DrawnFindings {
 public:
  enum Gravity { missing, extra, recolored, moved, hidden, texts };
  static constexpr std::size_t kGravities = 6;
  /// Items of one meaning follow each other: what is true of both is said once.
  void add(Gravity gravity, std::string text) {
    std::vector<std::string>& lines = lines_[gravity];
    if (lines.empty() || lines.back() != text) lines.push_back(std::move(text));
  }
  [[nodiscard]] std::vector<std::string> all() const {
    std::vector<std::string> result;
    for (const auto& lines : lines_) result.insert(result.end(), lines.begin(), lines.end());
    return result;
  }

 private:
  std::array<std::vector<std::string>, kGravities> lines_;
};

/// Compares an item that both pictures have; true if there is a finding.
bool compare_item(const Drawn& a, const Drawn& b, DrawnFindings& findings) {
  const bool same_color = a.color == b.color;
  if (!same_color) {
    const char* verb = a.kind == DrawnKind::leaf ? " tinted from " : " recoloured from ";
    findings.add(DrawnFindings::recolored,
                 name_of(a) + verb + color_text(a.color) + " to " + color_text(b.color));
  }
  if (!same_place(a, b)) findings.add(DrawnFindings::moved, name_of(a) + shift_text(a, b));
  return !same_color || !same_place(a, b);
}

void compare_pixels_of(const Drawn& a, std::uint32_t gone, std::uint32_t come, DrawnFindings& findings) {
  const std::uint32_t changed = std::max(gone, come);
  if (changed < std::max(kClearlySeen, a.pixels / 50)) return;
  const std::string what = gone >= come ? " is not seen in " + std::to_string(gone) + " of its "
                                        : " is seen in " + counted(come, "pixel") + " beside its ";
  findings.add(DrawnFindings::hidden, name_of(a) + what + counted(a.pixels, "pixel"));
}

void compare_items(const FrameIds& reference, const FrameIds& test, DrawnFindings& findings) {
  const Ids ids = align(reference, test);
  const auto gone = count_gone(ids, ids.reference, ids.test);
  const auto come = count_gone(ids, ids.test, ids.reference);
  const auto count = [](const auto& counts, std::uint32_t item) {
    const auto found = counts.find(item);
    return found == counts.end() ? 0U : found->second;
  };
  const std::map<Key, std::uint32_t> others = index_of(test.list);
  const std::map<Key, std::uint32_t> own = index_of(reference.list);
  for (const auto& [key, item] : own) {
    const Drawn& a = reference.list.items[item - 1];
    const auto same = others.find(key);
    if (same == others.end()) {
      findings.add(DrawnFindings::missing, name_of(a) + " missing");
    } else if (!compare_item(a, test.list.items[same->second - 1], findings)) {
      compare_pixels_of(a, count(gone, item), count(come, item), findings);
    }
  }
  for (const auto& [key, item] : others)
    if (!own.contains(key)) findings.add(DrawnFindings::extra, name_of(test.list.items[item - 1]) + " extra");
}

/// How far the same text may be from its place in its row: releases of Dear ImGui have boxes around it of
/// other widths. The letters themselves are compared as pixels.
constexpr int kTextSlack = 2;

bool is_in_place(const DrawnText& a, const DrawnText& b) {
  return a.y == b.y && std::abs(a.x - b.x) <= kTextSlack && a.text == b.text;
}

/// Drops each text of the one list with one of the other list that is in its place.
void drop_common(std::vector<DrawnText>& texts, std::vector<DrawnText>& others) {
  std::erase_if(texts, [&](const DrawnText& text) {
    const auto other = std::ranges::find_if(others, [&](const DrawnText& o) { return is_in_place(text, o); });
    if (other == others.end()) return false;
    others.erase(other);
    return true;
  });
}

void compare_texts(const DrawList& reference, const DrawList& test, DrawnFindings& findings) {
  std::vector<DrawnText> gone = reference.texts;
  std::vector<DrawnText> come = test.texts;
  drop_common(gone, come);
  std::map<std::pair<int, int>, std::pair<std::string, std::string>> texts;
  for (const DrawnText& text : gone) texts[{text.y, text.x}].first = text.text;
  for (const DrawnText& text : come) texts[{text.y, text.x}].second = text.text;
  for (const auto& [place, text] : texts)
    findings.add(DrawnFindings::texts, "text at (" + std::to_string(place.second) + ", " +
                                           std::to_string(place.first) + ") is '" + text.second +
                                           "' and not '" + text.first + "'");
}

}  // namespace

std::vector<std::string> compare_drawn(const FrameIds& reference, const FrameIds& test) {
  DrawnFindings findings;
  compare_items(reference, test, findings);
  compare_texts(reference.list, test.list, findings);
  return findings.all();
}

Image id_difference(const FrameIds& reference, const FrameIds& test) {
  const Ids ids = align(reference, test);
  Image image = make_image(ids.width, ids.height);
  auto out = image.rgba.begin();
  for (std::size_t i = 0; i < ids.reference.size(); ++i) {
    const std::uint32_t a = ids.reference[i];
    const std::uint32_t b = ids.test[i];
    const auto grey = static_cast<std::uint8_t>(a == 0 ? 255 : 190 + a * 37 % 48);
    Color color{grey, grey, grey};
    if (a != b) color = b == 0 ? Color{213, 30, 30} : a == 0 ? Color{0, 90, 200} : Color{150, 40, 170};
    for (const std::uint8_t value : {color.r, color.g, color.b, color.a}) *out++ = value;
  }
  return image;
}

}  // namespace kerf

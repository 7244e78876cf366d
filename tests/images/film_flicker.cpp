#include "tests/images/film_flicker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <tuple>

#include "frames/diff/frame_pairs.h"
#include "frames/sequence/draw_list_file.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using Key = std::tuple<DrawnKind, std::uint32_t, std::uint32_t>;
using Items = std::map<Key, Drawn>;

struct Frame {
  Image image;
  FrameIds ids;
  Items items;
};

Frame read_frame(const std::filesystem::path& path) {
  auto stored = read_ids(path);
  if (!stored) throw std::runtime_error(path.string() + " has no ids; draw it with --ids");
  Frame frame{read_png(path), std::move(stored->ids), {}};
  for (const Drawn& drawn : frame.ids.list.items)
    if (drawn.right >= drawn.left) frame.items.emplace(Key{drawn.kind, drawn.a, drawn.b}, drawn);
  return frame;
}

bool same(const Drawn& a, const Drawn& b) {
  return a.color == b.color && a.left == b.left && a.top == b.top && a.right == b.right &&
         a.bottom == b.bottom;
}

bool is_still(const Frame& other, const Drawn& drawn) {
  const auto found = other.items.find({drawn.kind, drawn.a, drawn.b});
  return found != other.items.end() && same(found->second, drawn);
}

/// Where something has changed that may change pixels.
class Explained {
 public:
  Explained(int width, int height)
      : width_(width),
        height_(height),
        mask_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void add(double left, double top, double right, double bottom) {
    const auto clamp = [](double x, int most) { return static_cast<int>(std::clamp(x, 0.0, double(most))); };
    for (int y = clamp(top, height_); y < clamp(bottom, height_); ++y)
      for (int x = clamp(left, width_); x < clamp(right, width_); ++x) mask_[at(x, y)] = 1;
  }
  void add_outline(const Drawn& drawn) {
    add(drawn.left - 2.0, drawn.top, drawn.left + 3.0, drawn.bottom);
    add(drawn.right - 2.0, drawn.top, drawn.right + 3.0, drawn.bottom);
    add(drawn.left, drawn.top - 2.0, drawn.right, drawn.top + 3.0);
    add(drawn.left, drawn.bottom - 2.0, drawn.right, drawn.bottom + 3.0);
  }
  /// In 3D the shadow of an object lies straight below it, and is no item.
  void add_shadow(const Drawn& drawn) {
    const float width = drawn.right - drawn.left;
    const float height = drawn.bottom - drawn.top;
    add(drawn.left - width, drawn.top, drawn.right + width, drawn.bottom + 9 * std::max(width, height));
  }
  [[nodiscard]] bool has(int x, int y) const { return mask_[at(x, y)] != 0; }

  /// What comes, goes or changes against another frame: the pixels of it and those beside, and of panes,
  /// which the id image leaves out, all that they span; lines of text that change.
  void add_changes(const Frame& frame, const Frame& other) {
    std::vector<char> changed(frame.ids.list.items.size() + 1);
    for (std::size_t i = 0; i + 1 < changed.size(); ++i) {
      const Drawn& drawn = frame.ids.list.items[i];
      if (drawn.right < drawn.left || is_still(other, drawn)) continue;
      changed[i + 1] = 1;
      if (drawn.kind == DrawnKind::object) add_shadow(drawn);
      if (drawn.kind == DrawnKind::leaf) add_outline(drawn);
      if (drawn.kind == DrawnKind::plane)
        add(drawn.left - 2.0, drawn.top - 2.0, drawn.right + 3.0, drawn.bottom + 3.0);
    }
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        if (const auto item = item_of(frame.ids.image.pixel(x, y));
            item < changed.size() && changed[item] != 0)
          add(x - 2, y - 2, x + 3, y + 3);
    for (const DrawnText& text : frame.ids.list.texts)
      if (std::ranges::find(other.ids.list.texts, text) == other.ids.list.texts.end())
        add(text.x, text.y, text.x + 10.0 * static_cast<double>(text.text.size()), text.y + 22.0);
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_;
  int height_;
  std::vector<char> mask_;
};

bool has_operators(const Frame& frame) {
  return std::ranges::any_of(frame.ids.list.items,
                             [](const Drawn& drawn) { return drawn.kind == DrawnKind::operation; });
}

/// Whether so many things that neither come nor go are elsewhere that it must be the camera.
bool view_has_changed(const Frame& a, const Frame& b) {
  std::size_t both = 0;
  std::size_t moved = 0;
  for (const auto& [key, drawn] : a.items) {
    if (std::get<0>(key) != DrawnKind::object) continue;
    const auto found = b.items.find(key);
    if (found == b.items.end()) continue;
    ++both;
    moved +=
        std::abs(found->second.left - drawn.left) + std::abs(found->second.top - drawn.top) > 0.02F ? 1 : 0;
  }
  return both > 0 && moved == both;
}

/// Panes become a little clearer with each leaf that is added: by invisible steps.
bool look_alike(const std::uint8_t* a, const std::uint8_t* b) {
  constexpr int kSeen = 6;
  return std::abs(a[0] - b[0]) < kSeen && std::abs(a[1] - b[1]) < kSeen && std::abs(a[2] - b[2]) < kSeen;
}

void compare_images(const Frame& a, const Frame& b, FilmFlicker& flicker) {
  if (has_operators(a) || has_operators(b) || view_has_changed(a, b)) return;
  Explained explained(a.image.width, a.image.height);
  explained.add_changes(a, b);
  explained.add_changes(b, a);
  std::uint64_t unexplained = 0;
  for (int y = 0; y < a.image.height; ++y) {
    for (int x = 0; x < a.image.width; ++x) {
      if (look_alike(a.image.pixel(x, y), b.image.pixel(x, y))) continue;
      ++flicker.changed;
      if (!explained.has(x, y)) ++unexplained;
    }
  }
  ++flicker.compared;
  flicker.unexplained += unexplained;
  flicker.most_unexplained = std::max(flicker.most_unexplained, unexplained);
}

std::string ramp_of(const Frame& frame) {
  for (const DrawnText& text : frame.ids.list.texts)
    if (text.text.find("leaf of 0-") != std::string::npos) return text.text;
  return "";
}

/// The name of a highlighted operator, as the draw list has it and as its label is written.
std::map<std::string, DrawnText> labels_of(const Frame& frame) {
  std::map<std::string, DrawnText> labels;
  for (const Drawn& drawn : frame.ids.list.items)
    if (drawn.kind == DrawnKind::operation)
      for (const DrawnText& text : frame.ids.list.texts)
        if ("operator " + text.text == name_of(drawn)) labels[text.text] = text;
  return labels;
}

void compare_labels(const Frame& a, const Frame& b, FilmFlicker& flicker) {
  const auto before = labels_of(a);
  for (const auto& [name, label] : labels_of(b)) {
    const auto known = before.find(name);
    if (known == before.end()) continue;
    ++flicker.labels;
    const int moved = std::max(std::abs(known->second.x - label.x), std::abs(known->second.y - label.y));
    flicker.label_jumps += moved > 2 ? 1 : 0;
  }
}

/// Lives of highlights that have begun and ended within the film.
class Lives {
 public:
  void see(const Frame& frame, bool is_first) {
    std::map<Key, std::uint32_t> still;
    for (const auto& [key, drawn] : frame.items) {
      if (std::get<0>(key) != DrawnKind::operation) continue;
      const auto known = running_.find(key);
      still[key] = known != running_.end() ? known->second + 1 : is_first ? kUnknown : 1;
    }
    for (const auto& [key, life] : running_)
      if (!still.contains(key) && life < kUnknown) ended_.push_back(life);
    running_ = std::move(still);
  }
  [[nodiscard]] std::vector<std::uint32_t> ended() && {
    std::ranges::sort(ended_);
    return std::move(ended_);
  }

 private:
  static constexpr std::uint32_t kUnknown = 1U << 30U;
  std::map<Key, std::uint32_t> running_;
  std::vector<std::uint32_t> ended_;
};

void count_blinking(const Frame& a, const Frame& b, const Frame& c, FilmFlicker& flicker) {
  const auto color = [](const Frame& frame, const Key& key) {
    const auto found = frame.items.find(key);
    return found == frame.items.end() ? Color{0, 0, 0, 0} : found->second.color;
  };
  const auto look = [&](const Key& key) {
    if (std::get<0>(key) != DrawnKind::pair) return;
    ++flicker.pairs;
    flicker.blinking_pairs += color(a, key) == color(c, key) && !(color(a, key) == color(b, key)) ? 1 : 0;
  };
  for (const auto& [key, drawn] : b.items) look(key);
  for (const auto& [key, drawn] : a.items)
    if (!b.items.contains(key)) look(key);
}

void compare(const Frame& a, const Frame& b, FilmFlicker& flicker) {
  compare_images(a, b, flicker);
  compare_labels(a, b, flicker);
  flicker.scale_changes += ramp_of(a) != ramp_of(b) ? 1 : 0;
  flicker.view_changes += view_has_changed(a, b) ? 1 : 0;
}

}  // namespace

FilmFlicker measure_flicker(const std::filesystem::path& folder) {
  const auto frames = pair_frames(folder, folder).frames;
  if (frames.size() < 2) throw std::runtime_error(folder.string() + " holds no two frames");
  FilmFlicker flicker;
  Lives lives;
  std::array<Frame, 3> last;
  for (const FramePair& pair : frames) {
    std::rotate(last.begin(), last.begin() + 1, last.end());
    last[2] = read_frame(pair.test);
    lives.see(last[2], flicker.frames == 0);
    ++flicker.frames;
    if (flicker.frames >= 2) compare(last[1], last[2], flicker);
    if (flicker.frames >= 3) count_blinking(last[0], last[1], last[2], flicker);
  }
  flicker.lives = std::move(lives).ended();
  return flicker;
}

}  // namespace kerf::test

#include <algorithm>
#include <cmath>

#include "viz/draw/flow.h"
#include "viz/draw/letters.h"
#include "viz/draw/overlay.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

std::string number(std::uint64_t value, std::size_t width) { return padded(std::to_string(value), width); }

/// A fraction in per cent with one decimal.
std::string percent(double fraction) {
  const auto tenths = static_cast<std::int64_t>(std::llround(std::clamp(fraction, -1.0, 1e6) * 1000));
  const std::string digits =
      std::to_string(std::abs(tenths) / 10) + "." + std::to_string(std::abs(tenths) % 10);
  return padded((tenths < 0 ? "-" : "") + digits, 5) + " %";
}

/// The step first, if it has no place on one of the first lines.
std::vector<CaptionItem> with_step_in(int lines, const Font& font, int picture_width,
                                      std::vector<CaptionItem> items) {
  const auto step = std::ranges::find(items, "step", &CaptionItem::word);
  if (step == items.end()) return items;
  const flow::Fitted fitted = flow::fit_across(font, picture_width, lines, flow::pieces_of(font, items));
  if (static_cast<std::size_t>(step - items.begin()) >= fitted.shown)
    std::rotate(items.begin(), step, step + 1);
  return items;
}

/// One that is wider than a line loses its end.
CaptionItem within_line(const CaptionItem& item, std::size_t letters) {
  if (item.value.empty()) return {shortened(item.word, letters), ""};
  const std::string front = item.word + " ";
  const std::string text = shortened(front + item.value, letters);
  return text.starts_with(front) ? CaptionItem{item.word, text.substr(front.size())} : CaptionItem{text, ""};
}

}  // namespace

std::vector<CaptionItem> caption_items(const Caption& caption, bool has_tree,
                                       std::optional<std::uint32_t> outside) {
  std::vector<CaptionItem> items;
  if (!caption.scene.empty()) items.push_back({"scene", caption.scene});
  if (!caption.broad_phase.empty()) items.push_back({"broad phase", caption.broad_phase});
  if (caption.is_run)
    items.push_back({"step", caption.step_name.empty() ? number(caption.step, 5) : caption.step_name});
  items.push_back({"objects", number(caption.objects, 5)});
  if (caption.is_run) items.push_back({"moving", number(caption.moving, 5)});
  if (caption.knows_pairs) items.push_back({"pairs", number(caption.pairs, 5)});
  if (caption.knows_contacts) items.push_back({"contacts", number(caption.contacts, 5)});
  if (caption.theirs) {
    items.push_back({"they missed", number(caption.theirs->missed, 4)});
    items.push_back({"extra", number(caption.theirs->extra, 4)});
  }
  if (outside) items.push_back({"outside", number(*outside, 5)});
  if (!has_tree) return items;
  const Statistics& tree = caption.statistics;
  items.push_back({"height", number(tree.height, 2), true});
  items.push_back({"leaves", number(tree.leaves, 4)});
  items.push_back({"redundancy", percent(tree.redundancy)});
  items.push_back({"operators:", ""});
  for (int i = 0; i < kOperatorCount; ++i) {
    const auto op = static_cast<Operator>(i);
    items.push_back({std::string(to_string(op)), number(tree.count(op), 4)});
  }
  return items;
}

std::vector<flow::Piece> flow::pieces_of(const Font& font, std::span<const CaptionItem> items) {
  std::vector<Piece> pieces;
  for (const CaptionItem& item : items)
    pieces.push_back(
        {font.width(item.word) + (item.value.empty() ? 0 : font.width(" " + item.value)), item.begins_line});
  return pieces;
}

void draw_caption(const View& view, const Font& font, const Layout& layout,
                  const std::vector<CaptionItem>& all_items, const std::string& log, Overlay& overlay) {
  if (layout.caption_height == 0) return;
  add_rectangle_on_picture(overlay.shapes, view, {0, 0, view.picture_width, double(layout.caption_height)},
                           palette::kPanel);
  const int pad = flow::padding(font);
  const int room = (layout.caption_height - pad) / font.line_height();
  const int picture_width = static_cast<int>(view.picture_width);
  const std::vector<CaptionItem> items = with_step_in(room, font, picture_width, all_items);
  const flow::Fitted fitted = flow::fit_across(font, picture_width, room, flow::pieces_of(font, items));
  const std::size_t letters = font.letters(picture_width - 2 * pad);
  for (std::size_t i = 0; i < fitted.spots.size(); ++i) {
    const int y = pad + fitted.spots[i].line * font.line_height();
    const int x = fitted.spots[i].x;
    const CaptionItem item = within_line(i < fitted.shown ? items[i] : CaptionItem{flow::kMore, ""}, letters);
    overlay.text.add(font, x, y, item.word, palette::kFaintInk);
    overlay.text.add(font, x + font.width(item.word + " "), y, item.value, palette::kInk);
  }
  const int line = flow::lines(fitted.spots);
  if (!log.empty() && line < room)
    overlay.text.add(font, pad, pad + line * font.line_height(), log, palette::kInk);
}

}  // namespace kerf

#include "frames/sequence/draw_list_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "core/base/counted.h"
#include "core/files/part_file.h"
#include "core/files/whole_file.h"
#include "frames/page/json.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/json_number.h"
#include "frames/support/printed.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr const char* kDrawListFormat = "kerf-draw-1";

std::string hex_color(Color c) { return printed("#%02x%02x%02x%02x", c.r, c.g, c.b, c.a); }

Color parse_hex(const std::string& text) {
  constexpr int kHexadecimal = 16;
  constexpr std::size_t kLength = 9;  // #, and two digits for each of red, green, blue and opacity
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const bool has_form = text.size() == kLength && text.front() == '#';
  if (!has_form || std::from_chars(text.data() + 1, end, value, kHexadecimal).ptr != end)
    throw std::runtime_error("'" + text + "' is no colour");
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(value >> shift); };
  return {byte(24), byte(16), byte(8), byte(0)};
}

double hundredths(float x) { return std::round(double{x} * 100) / 100; }

Json item_json(const Drawn& drawn) {
  return {to_string(drawn.kind),
          drawn.a,
          drawn.b,
          hex_color(drawn.color),
          hundredths(drawn.left),
          hundredths(drawn.top),
          hundredths(drawn.right),
          hundredths(drawn.bottom),
          drawn.pixels};
}

DrawnKind parse_kind(const std::string& text) {
  for (int i = 0; i < kDrawnKindCount; ++i)
    if (to_string(static_cast<DrawnKind>(i)) == text) return static_cast<DrawnKind>(i);
  throw std::runtime_error("nothing is called '" + text + "'");
}

Drawn parse_item(const Json& json) {
  return {parse_kind(json.at(0)),
          whole_number<std::uint32_t>(json.at(1), "a"),
          whole_number<std::uint32_t>(json.at(2), "b"),
          parse_hex(json.at(3)),
          whole_number<std::uint32_t>(json.at(8), "pixels"),
          float_number(json.at(4), "left"),
          float_number(json.at(5), "top"),
          float_number(json.at(6), "right"),
          float_number(json.at(7), "bottom")};
}

/// One item a line, so that people can read a difference.
std::string to_json(const StoredIds& stored) {
  const DrawList& list = stored.ids.list;
  std::string text = "{\"format\": \"" + std::string(kDrawListFormat) +
                     "\",\n\"rasterizer\": " + Json(stored.rasterizer).dump() +
                     ",\n\"item\": \"kind, a, b, colour, left, top, right, bottom, pixels\",\n\"items\": [";
  for (std::size_t i = 0; i < list.items.size(); ++i)
    text += (i == 0 ? "\n" : ",\n") + item_json(list.items[i]).dump();
  text += "],\n\"texts\": [";
  for (std::size_t i = 0; i < list.texts.size(); ++i) {
    const DrawnText& line = list.texts[i];
    text += (i == 0 ? "\n" : ",\n") +
            Json({line.x, line.y, line.text}).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + "]}\n";
}

StoredIds parse(const std::filesystem::path& path) {
  const std::string bytes = read_whole_file(path);
  try {
    const Json json = Json::parse(bytes);
    if (json.at("format") != kDrawListFormat) throw std::runtime_error("it is of another format");
    StoredIds stored;
    stored.rasterizer = json.at("rasterizer");
    for (const Json& item : json.at("items")) stored.ids.list.items.push_back(parse_item(item));
    for (const Json& text : json.at("texts"))
      stored.ids.list.texts.push_back(
          {whole_number<int>(text.at(0), "x"), whole_number<int>(text.at(1), "y"), text.at(2)});
    return stored;
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot read " + path.string() + ": it is no draw list (" + error.what() + ")");
  }
}

/// Such a pixel would be taken for ground.
void check_numbers(const FrameIds& ids, const std::filesystem::path& path) {
  std::uint32_t highest = 0;
  for (std::size_t i = 0; i < ids.image.rgba.size(); i += 4)
    highest = std::max(highest, item_of(ids.image.rgba.data() + i));
  if (highest > ids.list.items.size())
    throw std::runtime_error("cannot use " + path.string() + ": a pixel is of item " +
                             std::to_string(highest) + ", and the draw list has " +
                             counted(ids.list.items.size(), "item"));
}

}  // namespace

void write_ids(const std::filesystem::path& frame, const StoredIds& stored) {
  write_png(ids_path(frame), stored.ids.image, Replace::earlier, Sync::later);
  PartFile list(draw_list_path(frame));
  list.write(to_json(stored));
  list.keep(Sync::later);
}

std::optional<StoredIds> read_ids(const std::filesystem::path& frame) {
  const bool has_image = std::filesystem::exists(ids_path(frame));
  const bool has_list = std::filesystem::exists(draw_list_path(frame));
  if (!has_image && !has_list) return std::nullopt;
  StoredIds stored = parse(draw_list_path(frame));
  stored.ids.image = read_png(ids_path(frame));
  check_numbers(stored.ids, ids_path(frame));
  return stored;
}

}  // namespace kerf

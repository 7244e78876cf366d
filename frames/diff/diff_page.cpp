#include "frames/diff/diff_page.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "frames/page/json.h"
#include "frames/page/page.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/support/printed.h"
#include "viz/draw/compare_drawn.h"
#include "viz/image/png.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

/// Beginning and end of the page: style and behaviour. Nothing is fetched from anywhere.
constexpr std::string_view kDiffPageHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>kerf diff</title><link rel="icon" href="data:,">
<style>
body{margin:0 auto;max-width:1900px;padding:1.5rem;font:16px/1.5 system-ui,sans-serif;color:#191919;background:#fafaf7}
h1{font-size:1.5rem;margin-bottom:.2rem}.sub{color:#555;margin-top:0}
section{margin-top:2.5rem;border-top:2px solid #0072b2}h2{font-size:1.2rem}
code{background:#eeeee9;padding:.3rem .6rem;border-radius:3px;user-select:all}
.trouble{color:#b00020;font-weight:bold}ul{max-height:14rem;overflow-y:auto;margin:.5rem 0}
.panels,.lenses{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(420px,100%),1fr));gap:.6rem}
.lenses{margin-top:.6rem}.lenses[hidden]{display:none}
figure{margin:0}figcaption{color:#555;font-size:.85rem}
img{display:block;width:100%;border:1px solid #d8d8d2;cursor:crosshair;box-sizing:border-box}
img[hidden]{display:none}.under{margin:.4rem 0;color:#555;font-size:.85rem}
.lens{height:180px;border:1px solid #d8d8d2;overflow:hidden;position:relative;image-rendering:pixelated;background-repeat:no-repeat}
.lens::after{content:"";position:absolute;left:50%;top:50%;width:8px;height:8px;margin:-4px;outline:1px solid #d00060}
button{font:inherit;font-size:.85rem;border:1px solid #c8c8c2;background:#fff;border-radius:3px;cursor:pointer}
</style></head><body>
)";

constexpr std::string_view kDiffPageFoot = R"(<script>
const kZoom = 8;
// The numbers of the items at each pixel, of the reference and of the new picture.
function itemsOf(section) {
  section.items ??= [...section.querySelectorAll("img[data-names]")].map(image => {
    const canvas = document.createElement("canvas");
    const width = canvas.width = image.naturalWidth, height = canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, width, height).data;
    return {side: image.alt, names: JSON.parse(image.dataset.names), width, pixels};
  });
  return section.items;
}
function nameAt({side, names, width, pixels}, x, y) {
  const at = 4 * (y * width + x);
  const item = pixels[at] * 65536 + pixels[at + 1] * 256 + pixels[at + 2];
  return `${side} ${item === 0 ? "ground" : names[item]}`;
}
function sayWhatIsAt(section, x, y) {
  const under = section.querySelector(".under");
  if (!under) return;
  const names = itemsOf(section).map(items => nameAt(items, x, y));
  under.textContent = `(${x}, ${y}): ${names.join(", ")}`;
}
function showLenses(section, x, y) {
  const lenses = section.querySelector(".lenses");
  const images = [...section.querySelectorAll(".panels img")];
  lenses.hidden = false;
  while (lenses.children.length < images.length) {
    const lens = document.createElement("div");
    lens.className = "lens";
    lenses.append(lens);
  }
  images.forEach((image, i) => {
    const lens = lenses.children[i];
    const source = `url("${image.dataset.own || image.src}")`;
    if (lens.dataset.set !== "yes") { lens.style.backgroundImage = source; lens.dataset.set = "yes"; }
    lens.style.backgroundSize = `${image.naturalWidth * kZoom}px ${image.naturalHeight * kZoom}px`;
    const left = lens.clientWidth / 2 - (x + 0.5) * kZoom, top = lens.clientHeight / 2 - (y + 0.5) * kZoom;
    lens.style.backgroundPosition = `${left}px ${top}px`;
    lens.title = `(${x}, ${y})`;
  });
  sayWhatIsAt(section, x, y);
}
for (const section of document.querySelectorAll("section")) {
  for (const image of section.querySelectorAll(".panels img")) {
    image.addEventListener("mousemove", event => {
      const box = image.getBoundingClientRect();
      const at = (place, size, pixels) => Math.max(0, Math.min(pixels - 1, Math.floor(place / size * pixels)));
      showLenses(section, at(event.clientX - box.left, box.width, image.naturalWidth),
                 at(event.clientY - box.top, box.height, image.naturalHeight));
    });
  }
  for (const button of section.querySelectorAll("button[data-x]"))
    button.addEventListener("click", () => showLenses(section, +button.dataset.x, +button.dataset.y));
  const changing = section.querySelector(".new img"), reference = section.querySelector(".reference img");
  if (!changing || !reference) continue;
  changing.dataset.own = changing.src;
  const caption = section.querySelector(".new figcaption"), words = caption.textContent;
  const swap = on => {
    changing.src = on ? reference.src : changing.dataset.own;
    caption.textContent = on ? "reference, while pointed at" : words;
  };
  changing.tabIndex = 0;
  for (const begin of ["mouseenter", "focus"]) changing.addEventListener(begin, () => swap(true));
  for (const end of ["mouseleave", "blur"]) changing.addEventListener(end, () => swap(false));
}
</script></body></html>
)";

/// Base64 (RFC 4648) of bytes, for pictures in pages.
std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0U; };
    const std::uint32_t group = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::uint32_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kLetters[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string shell_word(const std::string& word) {
  const bool is_plain =
      !word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+,:=@%-") ==
          std::string::npos;
  return is_plain ? word : shell_quoted(word);
}

std::string picture(const Image& image, const std::string& title, const std::string& kind) {
  return "<figure class=\"" + kind + "\"><figcaption>" + title + "</figcaption><img alt=\"" + title +
         "\" src=\"data:image/png;base64," + base64(encode_png(image)) + "\"></figure>\n";
}

/// The picture if it can be read, whatever is wrong with the other one.
std::optional<Image> try_read(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  try {
    return read_stored_picture(path).image;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// The names of the items that are seen, by number.
Json names_of(const FrameIds& ids) {
  std::vector<bool> is_seen(ids.list.items.size() + 1);
  for (std::size_t i = 0; i < ids.image.rgba.size(); i += 4)
    if (const std::uint32_t item = item_of(ids.image.rgba.data() + i); item < is_seen.size())
      is_seen[item] = true;
  Json names = Json::object();
  for (std::size_t item = 1; item < is_seen.size(); ++item)
    if (is_seen[item]) names[std::to_string(item)] = name_of(ids.list.items[item - 1]);
  return names;
}

/// An id image for the page's script: its colours are numbers.
std::string hidden_ids(const FrameIds& ids, const std::string& side) {
  return "<img hidden alt=\"" + side + "\" data-names=\"" + escaped(json_text(names_of(ids), -1)) +
         "\" src=\"data:image/png;base64," + base64(encode_png(ids.image)) + "\">\n";
}

/// What the ids of a frame add to the page.
struct IdParts {
  std::string panel;   ///< one of the panels
  std::string hidden;  ///< from which the script says what lies where; behind the panels
};

IdParts id_parts(const FramePair& frame) {
  try {
    const auto a = read_ids(frame.reference);
    const auto b = read_ids(frame.test);
    if (!a || !b) return {};
    return {picture(id_difference(a->ids, b->ids), "ids: red gone, blue come, violet changed, grey the same",
                    "ids"),
            "<p class=\"under\">Point at a picture: here stands what lies there.</p>\n" +
                hidden_ids(a->ids, "reference") + hidden_ids(b->ids, "new")};
  } catch (const std::exception&) {
    return {};
  }
}

std::string panels(const FrameDiff& diff) {
  const std::optional<Image> reference = try_read(diff.frame.reference);
  const std::optional<Image> test = try_read(diff.frame.test);
  std::string text = "<div class=\"panels\">\n";
  IdParts ids;
  if (test) text += picture(*test, reference ? "new, or the reference while pointed at" : "new", "new");
  if (reference) text += picture(*reference, "reference", "reference");
  if (reference && test && diff.trouble.empty()) {
    text +=
        picture(heat_map(flip_errors(*reference, *test)), "FLIP, from black (none) to yellow (1)", "heat");
    ids = id_parts(diff.frame);
  }
  return text + ids.panel + "</div>\n" + ids.hidden + "<div class=\"lenses\" hidden></div>\n";
}

std::string list(const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string text = "<ul>\n";
  for (const std::string& line : lines) text += "<li>" + escaped(line) + "</li>\n";
  return text + "</ul>\n";
}

std::string figures(const FrameDiff& diff) {
  if (!diff.flip) return "";
  std::string line = printed("FLIP: largest %.4f, mean %.6f. Worst at", diff.flip->max, diff.flip->mean);
  for (const FlipPixel& pixel : diff.flip->worst)
    line += printed(" <button data-x=\"%d\" data-y=\"%d\">(%d, %d) %.3f</button>", pixel.x, pixel.y, pixel.x,
                    pixel.y, pixel.error);
  return "<p>" + line + "</p>\n";
}

std::string section(const FrameDiff& diff) {
  std::string text = "<section><h2>" + escaped(diff.frame.name) + "</h2>\n";
  if (!diff.trouble.empty()) text += "<p class=\"trouble\">" + escaped(diff.trouble) + "</p>\n";
  return text + list(diff.reasons) + figures(diff) + panels(diff) + "</section>\n";
}

}  // namespace

std::string approve_command(const DiffResult& result) {
  return "kerf diff " + shell_word(result.reference.string()) + " " + shell_word(result.test.string()) +
         " --approve";
}

std::string diff_page(const DiffResult& result) {
  std::string text = std::string(kDiffPageHead) + "<h1>" + escaped(summary_line(result)) + "</h1>\n";
  text += "<p class=\"sub\">reference " + escaped(result.reference.string()) + ", new " +
          escaped(result.test.string()) + "</p>\n" + list(result.notes) + list(result.faults) +
          list(manifest_lines(result));
  if (!result.is_same())
    text +=
        "<p>If the new frames are right, this puts those that differ in place of their references, and "
        "touches no other:</p>\n<p><code id=\"approve\">" +
        escaped(approve_command(result)) + "</code></p>\n";
  std::size_t shown = 0;
  std::vector<std::string> others;
  for (const FrameDiff& diff : result.frames) {
    if (diff.same) continue;
    if (shown++ < kMostShownFrames) {
      text += section(diff);
    } else {
      others.push_back(diff.frame.name);
    }
  }
  if (!others.empty()) text += "<h2>not shown</h2>\n" + list(others);
  return text + std::string(kDiffPageFoot);
}

}  // namespace kerf

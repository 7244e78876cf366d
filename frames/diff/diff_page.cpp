#include "frames/diff/diff_page.h"

#include <optional>
#include <stdexcept>

#include "frames/diff/diff_page_parts.h"
#include "frames/page/json.h"
#include "frames/page/page.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/support/base64.h"
#include "viz/draw/compare_drawn.h"
#include "viz/image/png.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

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
  char text[200];
  std::snprintf(text, sizeof text, "FLIP: largest %.4f, mean %.6f. Worst at", diff.flip->max,
                diff.flip->mean);
  std::string line = text;
  for (const FlipPixel& pixel : diff.flip->worst) {
    std::snprintf(text, sizeof text, " <button data-x=\"%d\" data-y=\"%d\">(%d, %d) %.3f</button>", pixel.x,
                  pixel.y, pixel.x, pixel.y, pixel.error);
    line += text;
  }
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

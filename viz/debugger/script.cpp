#include "viz/debugger/script.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "viz/debugger/script_keys.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

template <class Error = ScriptError>
[[noreturn]] void fail(const ScriptLine& line, const std::string& what) {
  std::string text;
  for (const std::string& word : line.words) text += (text.empty() ? "" : " ") + word;
  throw Error("line " + std::to_string(line.number) + ", '" + text + "': " + what);
}

/// Beyond any window, and small enough to be cut to a whole number of pixels.
constexpr float kMostPixels = 1e6F;
/// Hours of playing.
constexpr int kMostFrames = 1'000'000;

/// A place along a window, a share of it or turns of a wheel.
std::optional<float> extent_of(std::string_view text) {
  const auto value = read_number<float>(text);
  return value && std::abs(*value) <= kMostPixels ? value : std::nullopt;
}

bool is_inside(const std::pair<float, float>& place, double width, double height) {
  return place.first >= 0 && place.first <= width && place.second >= 0 && place.second <= height;
}

/// "a,b" as two numbers.
std::optional<std::pair<float, float>> two_numbers(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto a = extent_of(text.substr(0, comma));
  const auto b = extent_of(text.substr(comma + 1));
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

std::vector<std::string> words_of(int number, std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false;
  bool begun = false;
  for (const char c : text) {
    if (c == '"') {
      quoted = !quoted;
      begun = true;
    } else if (c == '#' && !quoted && !begun) {
      break;
    } else if ((c == ' ' || c == '\t' || c == '\r') && !quoted) {
      if (begun) words.push_back(std::exchange(word, {}));
      begun = false;
    } else {
      word += c;
      begun = true;
    }
  }
  if (quoted) throw ScriptError("line " + std::to_string(number) + ": a quote is not closed");
  if (begun) words.push_back(word);
  return words;
}

/// All names, each after a space.
template <class Value>
std::string names_of(const std::map<std::string, Value>& known) {
  std::string names;
  for (const auto& [name, value] : known) names += " " + name;
  return names;
}

/// "object:5", by its name, or "node:5".
std::optional<Selection> named_thing(const std::string& text, const GivenNames& names) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::string_view id = std::string_view(text).substr(colon + 1);
  if (text.starts_with("object:")) {
    const auto given = parse_given_id(id);
    const auto object = given ? names.find_object(*given) : std::nullopt;
    return object ? std::optional<Selection>(*object) : std::nullopt;
  }
  const auto node = read_number<std::uint32_t>(id);
  return node && text.starts_with("node:") ? std::optional<Selection>(NodeId{*node}) : std::nullopt;
}

const std::string& word_of(const ScriptLine& line, std::size_t k) {
  if (k >= line.words.size()) fail(line, "something is missing after '" + line.words.back() + "'");
  return line.words[k];
}

bool has_word(const ScriptLine& line, std::size_t k, std::string_view word) {
  return k < line.words.size() && line.words[k] == word;
}

bool compare(const std::string& a, const std::string& op, const std::string& b, const ScriptLine& line) {
  if (op == "~") return a.find(b) != std::string::npos;
  if (op == "!~") return a.find(b) == std::string::npos;
  if (op == "==")
    return a == b || (read_number<double>(a) && read_number<double>(a) == read_number<double>(b));
  if (op == "!=") return !compare(a, "==", b, line);
  const auto x = read_number<double>(a);
  const auto y = read_number<double>(b);
  if (!x || !y) fail(line, "'" + a + "' and '" + b + "' are not both numbers");
  if (op == "<") return *x < *y;
  if (op == "<=") return *x <= *y;
  if (op == ">") return *x > *y;
  if (op == ">=") return *x >= *y;
  fail(line, "'" + op + "' is none of == != < <= > >= ~ !~");
}

}  // namespace

std::vector<ScriptLine> parse_script(std::string_view text) {
  std::vector<ScriptLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ScriptLine line{number, words_of(number, text.substr(0, end))};
    if (!line.words.empty()) lines.push_back(std::move(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

ScriptPlayer::ScriptPlayer(Debugger& debugger, int width, int height, PictureFolder folder,
                           std::function<void()> present)
    : debugger_(debugger),
      width_(width),
      height_(height),
      folder_(std::move(folder)),
      present_(std::move(present)) {}

void ScriptPlayer::play(const std::vector<ScriptLine>& lines) {
  frames(2);
  for (const ScriptLine& line : lines) {
    play(line);
    if (debugger_.takes_screenshot()) take_picture(debugger_.facts()["position"]);
  }
}

void ScriptPlayer::frames(int count) {
  for (int k = 0; k < count; ++k) {
    debugger_.frame(input_, width_, height_);
    if (present_) present_();
    input_.end_frame();
  }
}

void ScriptPlayer::play(const ScriptLine& line) {
  const std::string& verb = line.words[0];
  const auto word = [&](std::size_t k) -> const std::string& { return word_of(line, k); };
  if (verb == "key") return press(line, word(1));
  if (verb == "welcome") {
    debugger_.welcome();
    return frames(2);
  }
  if (verb == "click" || verb == "double") {
    input_.shift = has_word(line, 2, "shift");
    input_.control = has_word(line, 2, "ctrl");
    click(place(line, word(1)), 0, verb == "double" ? 2 : 1);
    input_.shift = input_.control = false;
    return frames(1);
  }
  if (verb == "hover") {
    const Point point = place(line, word(1));
    input_.mouse_x = point.x;
    input_.mouse_y = point.y;
    return frames(2);
  }
  if (verb == "drag") return drag(line);
  if (verb == "wheel") return turn_wheel(line);
  if (verb == "type") {
    input_.text = word(1);
    return frames(2);
  }
  if (verb == "wait") {
    const auto count = read_number<int>(word(1));
    if (!count || *count < 0 || *count > kMostFrames)
      fail(line, "'" + word(1) + "' is no whole number of frames from 0 to " + std::to_string(kMostFrames));
    return frames(*count);
  }
  if (verb == "screenshot") {
    if (word(1).empty() || word(1).find('/') != std::string::npos)
      fail(line, "'" + word(1) + "' is no name of a picture: all of them lie in one folder");
    return take_picture(word(1));
  }
  if (verb == "save" || verb == "load") return use_session(line);
  if (verb == "drop") {
    if (word(1).empty()) fail(line, "it is written `drop FILE`");
    input_.dropped = word(1);
    return frames(2);
  }
  if (verb == "expect") return expect(line);
  if (verb == "remember") {
    remembered_[word(1)] = fact(line, word(2));
    return;
  }
  fail(line, "'" + verb +
                 "' is none of key, click, double, hover, drag, wheel, type, wait, screenshot, expect, "
                 "remember, welcome, save, load, drop");
}

/// "save session FILE" and "load session FILE"; without FILE the one that is kept, else the one beside the
/// recording.
void ScriptPlayer::use_session(const ScriptLine& line) {
  if (!has_word(line, 1, "session") || has_word(line, 2, ""))
    fail(line, "it is written `" + line.words[0] + " session [FILE]`");
  std::filesystem::path file = debugger_.session_file();
  if (file.empty()) file = session_path(debugger_.model().run().path());
  if (line.words.size() > 2) file = line.words[2];
  try {
    const bool saves = line.words[0] == "save";
    const std::string problem = saves ? debugger_.save_session(file) : "";
    if (!problem.empty()) fail(line, problem);
    if (!saves) debugger_.load_session(file);
  } catch (const ScriptError&) {
    throw;
  } catch (const std::runtime_error& error) {
    fail(line, error.what());
  }
  frames(2);
}

/// As a person does it: the mouse is there before the click, and stays for a frame after it.
void ScriptPlayer::click(const Point& point, int button, int times) {
  input_.mouse_x = point.x;
  input_.mouse_y = point.y;
  frames(2);
  for (int k = 0; k < times; ++k) {
    input_.buttons[static_cast<std::size_t>(button)] = true;
    frames(1);
    input_.buttons[static_cast<std::size_t>(button)] = false;
    frames(1);
  }
  frames(1);
}

void ScriptPlayer::drag(const ScriptLine& line) {
  constexpr int kSteps = 8;
  const Point from = place(line, word_of(line, 1));
  const Point to = place(line, word_of(line, 2));
  const std::size_t button = has_word(line, 3, "right") ? 1 : has_word(line, 3, "middle") ? 2 : 0;
  input_.shift = has_word(line, 3, "shift");
  input_.mouse_x = from.x;
  input_.mouse_y = from.y;
  frames(2);
  input_.buttons[button] = true;
  frames(1);
  for (int k = 1; k <= kSteps; ++k) {
    const float share = static_cast<float>(k) / kSteps;
    input_.mouse_x = from.x + share * (to.x - from.x);
    input_.mouse_y = from.y + share * (to.y - from.y);
    frames(1);
  }
  input_.buttons[button] = false;
  frames(1);
  input_.shift = false;
  frames(1);
}

void ScriptPlayer::turn_wheel(const ScriptLine& line) {
  const std::string& text = word_of(line, 1);
  const auto turns = extent_of(text);
  if (!turns) fail(line, "'" + text + "' is no number of turns such as 2 or -0.5");
  (has_word(line, 2, "sideways") ? input_.sideways : input_.wheel) = *turns;
  input_.shift = has_word(line, 2, "shift");
  frames(1);
  input_.shift = false;
  frames(1);
}

void ScriptPlayer::press(const ScriptLine& line, const std::string& text) {
  std::string name = text;
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto has = [&](std::string_view modifier) {
    const bool found = name.starts_with(modifier);
    if (found) name.erase(0, modifier.size());
    return found;
  };
  const bool control = has("ctrl+");
  const bool shift = has("shift+");
  const auto key = key_called(name);
  if (!key) fail(line, "there is no key '" + text + "'; there are 0 to 9" + names_of(key_names()));
  input_.shift = shift;
  input_.control = control;
  input_.key = key;
  frames(1);
  input_.shift = input_.control = false;
  frames(2);
}

/// The picture shows the state after all previous actions have been drawn.
void ScriptPlayer::take_picture(const std::string& name) {
  frames(2);
  const bool is_first = taken_.insert(name).second;
  std::filesystem::create_directories(folder_.path);
  write_png(folder_.path / (name + ".png"), debugger_.picture(),
            is_first ? folder_.replace : Replace::earlier);
}

std::string ScriptPlayer::fact(const ScriptLine& line, const std::string& name) {
  const auto facts = debugger_.facts();
  const auto found = facts.find(name);
  if (found != facts.end()) return found->second;
  fail(line, "there is nothing called '" + name + "'; there are" + names_of(facts));
}

void ScriptPlayer::expect(const ScriptLine& line) {
  if (line.words.size() != 4) fail(line, "it is written `expect NAME == VALUE`");
  const std::string found = fact(line, line.words[1]);
  std::string wanted = line.words[3];
  if (wanted.starts_with("$")) {
    const auto kept = remembered_.find(wanted.substr(1));
    if (kept == remembered_.end()) fail(line, "nothing was remembered as '" + wanted.substr(1) + "'");
    wanted = kept->second;
  }
  if (!compare(found, line.words[2], wanted, line))
    fail<ExpectationFailed>(line, line.words[1] + " is '" + found + "'");
}

/// "320,200" is a pixel, "play" a part of a panel, "view@0.5,0.25" a place within it by its share, "object:5"
/// or "node:5" the place of that object or node.
ScriptPlayer::Point ScriptPlayer::place(const ScriptLine& line, const std::string& word) {
  if (const auto pixel = two_numbers(word)) {
    if (!is_inside(*pixel, width_ - 1, height_ - 1))
      fail(line, word + " is no pixel of the window, which has " + std::to_string(width_) + "x" +
                     std::to_string(height_));
    return {pixel->first, pixel->second};
  }
  const std::size_t at = word.find('@');
  const std::string name = word.substr(0, at);
  std::pair<float, float> share{0.5F, 0.5F};
  if (at != std::string::npos) {
    const auto given = two_numbers(std::string_view(word).substr(at + 1));
    if (!given || !is_inside(*given, 1, 1))
      fail(line, "after the @ stand two shares from 0 to 1 such as 0.5,0.25");
    share = *given;
  }
  const auto scale = static_cast<float>(debugger_.scale());
  const GivenNames& given = debugger_.model().run().names();
  if (const auto thing = named_thing(name, given)) {
    const auto seen = debugger_.view().place_of(*thing);
    const auto view = debugger_.gui().find("view");
    if (!seen || !view) fail(line, to_string(*thing, given) + " is not seen");
    return {std::floor(view->x * scale) + seen->x, std::floor(view->y * scale) + seen->y};
  }
  const auto area = debugger_.gui().find(name);
  if (!area) {
    std::string names;
    for (const auto& [known, rectangle] : debugger_.gui().named()) names += " '" + known + "'";
    fail(line, "there is no '" + name + "' to be seen; there are" + names);
  }
  return {(area->x + area->width * share.first) * scale, (area->y + area->height * share.second) * scale};
}

}  // namespace kerf

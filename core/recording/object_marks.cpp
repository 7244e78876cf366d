#include "core/recording/object_marks.h"

#include <algorithm>
#include <cctype>

#include "core/base/damage.h"
#include "core/recording/database.h"

namespace kerf {
namespace {

std::string without_capitals(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::optional<Rgb> read_color(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  const std::string text = row.text(column);
  const std::optional<Rgb> color = parse_rgb(text);
  if (!color) fail_damaged("an object has the colour '" + text + "'");
  return color;
}

}  // namespace

bool is_label(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest &&
         std::ranges::none_of(text, [](unsigned char c) { return std::iscntrl(c) != 0; });
}

const ObjectMark* ObjectMarks::find(ObjectId object) const {
  const auto found = marks_.find(object);
  return found == marks_.end() ? nullptr : &found->second;
}

std::optional<Rgb> ObjectMarks::color(ObjectId object) const {
  const ObjectMark* const mark = find(object);
  return mark == nullptr ? std::nullopt : mark->color;
}

std::string ObjectMarks::title(ObjectId object, const std::string& number) const {
  const ObjectMark* const mark = find(object);
  return mark == nullptr || mark->label.empty() ? number : number + " " + mark->label;
}

std::vector<ObjectId> ObjectMarks::called(std::string_view text) const {
  const std::string wanted = without_capitals(text);
  std::vector<ObjectId> found;
  for (const auto& [object, mark] : marks_)
    if (!mark.label.empty() && without_capitals(mark.label).find(wanted) != std::string::npos)
      found.push_back(object);
  return found;
}

const char* const kMarkTable = R"sql(
CREATE TABLE object_marks(object INTEGER PRIMARY KEY, label TEXT NOT NULL, color TEXT);
)sql";

void write_marks(Database& database, const ObjectMarks& marks) {
  Statement put = database.prepare("INSERT INTO object_marks VALUES(?, ?, ?)");
  for (const auto& [object, mark] : marks.all()) {
    put.clear();
    put.bind(1, std::int64_t{object.value}).bind(2, mark.label);
    if (mark.color) put.bind(3, to_string(*mark.color));
    put.run();
  }
}

ObjectMarks read_marks(const Database& database) {
  ObjectMarks marks;
  Statement row = database.prepare("SELECT object, label, color FROM object_marks ORDER BY object");
  while (row.step()) {
    const ObjectId object{row.small(0)};
    ObjectMark mark{row.text(1), read_color(row, 2)};
    if (object.is_none() || !is_label(mark.label))
      fail_damaged("object " + std::to_string(object.value) + " has a label that cannot be shown");
    marks.set(object, std::move(mark));
  }
  return marks;
}

}  // namespace kerf

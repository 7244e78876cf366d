#include "frames/import/step_lines.h"

namespace kerf {
namespace {

Oddity kind_of(BoxLine::Oddity oddity) {
  switch (oddity) {
    case BoxLine::Oddity::half_blank:
      return Oddity::half_blank;
    case BoxLine::Oddity::not_a_number:
      return Oddity::not_a_number;
    case BoxLine::Oddity::inverted:
      return Oddity::inverted;
    case BoxLine::Oddity::infinite:
    case BoxLine::Oddity::none:
      break;
  }
  return Oddity::infinite;
}

bool is_in_quarantine(const BoxLine& line) {
  return line.oddity != BoxLine::Oddity::none && line.oddity != BoxLine::Oddity::infinite;
}

/// A part in quarantine takes the whole with it.
void join_boxes(BoxLine& first, const BoxLine& second) {
  if (is_in_quarantine(first)) return;
  GivenBox<3> box{second.min, second.max};
  if (is_in_quarantine(second))
    first.oddity = second.oddity;
  else
    box = join(GivenBox<3>{first.min, first.max}, box);
  first.min = box.min;
  first.max = box.max;
}

}  // namespace

StepLines::StepLines(BoxLines& boxes, const Survey& survey, bool unite, Oddities& oddities)
    : boxes_(boxes), survey_(survey), unites_(unite), oddities_(oddities), has_line_(boxes.next()) {}

const std::vector<BoxLine>& StepLines::next(const GivenStep& step) {
  for (const BoxLine& line : lines_)
    if (line.kind != BoxLine::Kind::nothing) last_box_[survey_.object(line.object).index()] = 0;
  lines_.clear();
  for (; has_line_ && boxes_.step().time == step.time; has_line_ = boxes_.next()) add(boxes_.read(), step);
  return lines_;
}

void StepLines::end() const {
  if (has_line_) boxes_.reject_change();
}

void StepLines::add(const BoxLine& line, const GivenStep& step) {
  if (line.oddity != BoxLine::Oddity::none) note_oddity(line, step);
  if (line.kind == BoxLine::Kind::nothing) return;
  const auto known = survey_.find(line.object);
  if (!known) boxes_.reject_change();
  const std::size_t object = known->index();
  if (last_box_.size() <= object) last_box_.resize(object + 1, 0);
  std::size_t& last = last_box_[object];
  if (line.kind == BoxLine::Kind::box && last != 0) return unite(lines_[last - 1], line, step);
  lines_.push_back(line);
  last = line.kind == BoxLine::Kind::box ? lines_.size() : 0;
}

void StepLines::unite(BoxLine& first, const BoxLine& second, const GivenStep& step) {
  if (!unites_)
    boxes_.reject(
        "object " + to_string(second.object) + " has a second box in step " + step.text +
        ", after that of line " + std::to_string(first.line) +
        "; --unite takes the smallest box that holds both, and whatever overlaps that is a pair then");
  oddities_.note(Oddity::united, [&] { return place(second, step); });
  const auto check = [&](const auto& said, const auto& other, const char* differing) {
    if (other && said != other)  // blank: as in the lines before
      boxes_.reject("object " + to_string(second.object) + " " + differing + " in step " + step.text +
                    ", and united it is one; give each box an object of its own");
  };
  check(first.fixed, second.fixed, "is both fixed and moving");
  check(first.category, second.category, "has boxes of different category or mask");
  check(first.mask, second.mask, "has boxes of different category or mask");
  check(first.turn, second.turn, "is turned in two ways");
  join_boxes(first, second);
}

void StepLines::note_oddity(const BoxLine& line, const GivenStep& step) {
  oddities_.note(kind_of(line.oddity), [&] { return place(line, step); });
}

std::string StepLines::place(const BoxLine& line, const GivenStep& step) const {
  return boxes_.table().name() + ", line " + std::to_string(line.line) + ": object " +
         to_string(line.object) + " in step " + step.text;
}

}  // namespace kerf

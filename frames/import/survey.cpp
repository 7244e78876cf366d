#include "frames/import/survey.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "frames/import/given_pairs.h"
#include "frames/import/signed_ids.h"
#include "frames/import/written_digits.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

/// A step of a table of boxes.
struct BoxStep {
  GivenStep step;
  std::size_t line = 0;  ///< its first
};

/// The most that a step of a table has: printf's %g leaves out zeros at the end.
struct StepWriting {
  std::int64_t digits = 0;  ///< of numbers only: a date is no rounded number
  std::int64_t decimals = 0;

  void note(const GivenStep& step) {
    const std::string_view text = step.text;
    const bool is_date = step.is_date();
    const auto written = read_digits(is_date ? text.substr(std::min(text.find('.'), text.size())) : text);
    if (!written) return;
    decimals = std::max(decimals, written->decimals);
    if (!is_date) digits = std::max(digits, written->significant);
  }

  /// Below this, two times of about this size are one where they are written so, rounded or cut.
  [[nodiscard]] long double last_place(long double time) const {
    constexpr std::int64_t kLeastDigits = 6;   // printf's; fewer are what the numbers have
    constexpr long double kBelowOne = 0.999L;  // since a difference of one place is rounded itself
    long double place = std::pow(10.0L, static_cast<long double>(-decimals));
    if (digits >= kLeastDigits && time != 0)
      place = std::max(place, std::pow(10.0L, std::floor(std::log10(std::abs(time))) + 1 -
                                                  static_cast<long double>(digits)));
    return kBelowOne * place;
  }
};

StepWriting writing_of_both(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs) {
  StepWriting of_boxes;
  StepWriting of_pairs;
  for (const BoxStep& box : boxes) of_boxes.note(box.step);
  for (const GivenPairs& of_step : pairs) of_pairs.note(of_step.step);
  return {std::min(of_boxes.digits, of_pairs.digits), std::min(of_boxes.decimals, of_pairs.decimals)};
}

/// Between the steps of boxes before and after this place, or before the last one; 0: there is one step.
long double length_at(const std::vector<BoxStep>& boxes, std::size_t after) {
  const std::size_t later = std::min(after, boxes.size() - 1);
  return later == 0 ? 0 : boxes[later].step.time - boxes[later - 1].step.time;
}

bool have_step(const std::vector<GivenPairs>& pairs, long double time) {
  const auto found = std::ranges::lower_bound(pairs, time, {}, [](const auto& of) { return of.step.time; });
  return found != pairs.end() && found->step.time == time;
}

/// Throws UsageError if pairs are of a step that no boxes have, but a step of boxes next to it, which has no
/// pairs, is the same one in as many digits as both tables have: times that were not written alike would make
/// a right engine's pairs missed in one step and extra in the other. Both rise; the message begins with
/// `pairs_name` and the line.
void check_alike(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs,
                 const std::string& pairs_name) {
  const StepWriting writing = writing_of_both(boxes, pairs);
  for (const auto& [step, lines] : pairs) {
    const auto found =
        std::ranges::lower_bound(boxes, step.time, {}, [](const BoxStep& box) { return box.step.time; });
    if (found != boxes.end() && found->step.time == step.time) continue;
    const auto after = static_cast<std::size_t>(found - boxes.begin());
    const long double nearest = std::min(writing.last_place(step.time), length_at(boxes, after) / 2);
    for (std::size_t k = std::max<std::size_t>(after, 1) - 1; k <= after && k < boxes.size(); ++k) {
      const GivenStep& other = boxes[k].step;
      if (std::abs(other.time - step.time) >= nearest || have_step(pairs, other.time)) continue;
      throw UsageError(pairs_name + ", line " + std::to_string(lines.front().line) + ": step " + step.text +
                       " is no step of the boxes, but step " + other.text +
                       " is the same in as many digits: write steps alike in all tables");
    }
  }
}

struct BoxSurvey {
  std::vector<BoxStep> steps;
  std::vector<GivenId> objects;    ///< sorted
  TableWriting digits;             ///< if there are nodes to compare them with
  bool leaves_remainders = false;  ///< beyond the nodes' digits
  BoundWriting writing;
};

void sort_unique(std::vector<GivenId>& ids) {
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// `notes_writing`: there are pairs to be judged by what was written.
BoxSurvey read_boxes(BoxLines& lines, const GivenTrees& trees, bool notes_writing, Oddities& oddities) {
  BoxSurvey survey;
  Remainders remainders(trees.digits);
  std::size_t sorted = 0;
  while (lines.next()) {
    GivenStep step = lines.step();
    if (!survey.steps.empty() && step.time < survey.steps.back().step.time)
      lines.reject("step " + step.text + " comes after step " + survey.steps.back().step.text);
    if (!survey.steps.empty())
      if (const std::string conflict = conflict_of(step, survey.steps.back().step); !conflict.empty())
        lines.reject(conflict);
    if (survey.steps.empty() || step.time > survey.steps.back().step.time)
      survey.steps.push_back({std::move(step), lines.table().line()});
    if (!trees.steps.empty()) {
      lines.note_digits(survey.digits);
      lines.note_remainders(remainders);
    }
    if (notes_writing) lines.note_writing(survey.writing);
    if (const auto object = lines.object()) survey.objects.push_back(*object);
    if (survey.objects.size() < 2 * sorted + 1'000'000) continue;
    sort_unique(survey.objects);  // so that memory depends on the number of objects
    sorted = survey.objects.size();
  }
  sort_unique(survey.objects);
  survey.leaves_remainders = remainders.are_many();
  note_cut(lines.table(), oddities);
  lines.rewind();
  return survey;
}

std::vector<GivenStep> union_of(const std::vector<BoxStep>& boxes, const std::vector<GivenPairs>& pairs,
                                const std::string& pairs_name, Oddities& oddities) {
  std::vector<GivenStep> steps;
  auto box = boxes.begin();
  for (const GivenPairs& of_step : pairs) {
    const std::string where = pairs_name + ", line " + std::to_string(of_step.pairs.front().line);
    const auto check = [&](const GivenStep& step) {
      const std::string conflict = conflict_of(of_step.step, step);
      if (!conflict.empty()) throw UsageError(where + ": " + conflict);
    };
    check(boxes.front().step);
    if (of_step.step.time < boxes.front().step.time)
      throw UsageError(where + ": step " + of_step.step.text +
                       " is before the first one of the boxes, step " + boxes.front().step.text);
    for (; box != boxes.end() && box->step.time < of_step.step.time; ++box) steps.push_back(box->step);
    const bool has_boxes = box != boxes.end() && box->step.time == of_step.step.time;
    if (has_boxes) check(box->step);
    if (!has_boxes) oddities.note(Oddity::no_boxes, [&] { return where + ": step " + of_step.step.text; });
    steps.push_back(has_boxes ? (box++)->step : of_step.step);
  }
  for (; box != boxes.end(); ++box) steps.push_back(box->step);
  return steps;
}

/// Nodes without objects to hold say nothing.
void check_steps(const std::vector<GivenNodes>& nodes, const std::string& nodes_name,
                 const std::vector<GivenStep>& steps) {
  for (const GivenNodes& of_step : nodes) {
    const std::string where = nodes_name + ", line " + std::to_string(of_step.line) + ": ";
    const auto found = std::ranges::lower_bound(steps, of_step.step.time, {}, &GivenStep::time);
    if (found == steps.end() || found->time != of_step.step.time)
      throw UsageError(where + "step " + of_step.step.text + " has neither boxes nor pairs");
    const std::string conflict = conflict_of(of_step.step, *found);
    if (!conflict.empty()) throw UsageError(where + conflict);
  }
}

void check_signs(const std::vector<GivenNodes>& nodes, const std::string& nodes_name, const Survey& survey) {
  for (const GivenNodes& of_step : nodes)
    for (const GivenNode& node : of_step.nodes)
      for (const GivenId& id : node.objects)
        if (survey.is_object(id)) check_sign(id, survey.objects, nodes_name, node.line);
}

/// A step is usually as long as most are.
void note_gaps(const std::vector<GivenStep>& steps, const std::vector<BoxStep>& boxes,
               const std::string& name, Oddities& oddities) {
  constexpr long double kMost = 1.5L;
  std::vector<long double> lengths;
  for (std::size_t k = 1; k < steps.size(); ++k) lengths.push_back(steps[k].time - steps[k - 1].time);
  if (lengths.empty()) return;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  for (std::size_t k = 1; k < steps.size(); ++k) {
    if (steps[k].time - steps[k - 1].time < kMost * *middle) continue;
    oddities.note(Oddity::gap, [&] {
      const auto box = std::ranges::lower_bound(boxes, steps[k].time, {},
                                                [](const BoxStep& step) { return step.step.time; });
      const bool has_line = box != boxes.end() && box->step.time == steps[k].time;
      return (has_line ? name + ", line " + std::to_string(box->line) + ": " : "") + "step " + steps[k].text +
             " follows step " + steps[k - 1].text;
    });
  }
}

/// None if there are no boxes, or no nodes, to be compared.
std::optional<TheirDigits> digits_of(const BoxSurvey& boxes, const GivenTrees& trees) {
  TheirDigits digits{boxes.digits.digits(), trees.digits.digits()};
  if (digits.boxes.significant == 0 || digits.nodes.significant == 0) return std::nullopt;
  Remainders of_nodes(boxes.digits);
  for (const GivenNodes& of_step : trees.steps)
    for (const GivenNode& node : of_step.nodes)
      for (std::size_t axis = 0; axis < node.min.size(); ++axis) {
        of_nodes.note(node.min[axis]);
        of_nodes.note(node.max[axis]);
      }
  digits.boxes.coarse = of_nodes.are_many();
  digits.nodes.coarse = boxes.leaves_remainders;
  return digits;
}

void note_coarse(const std::string& name, const TableWriting& writing, Oddities& oddities) {
  oddities.note(Oddity::coarse_table, [&] { return name + ": " + writing.text(); });
}

/// Whether objects may keep their own numbers: few are unused.
bool are_dense(const std::vector<GivenId>& objects) {
  return objects.empty() ||
         (!objects.front().negative && objects.back().magnitude < 4 * objects.size() + 1024);
}

bool count_from_one(const std::vector<GivenStep>& steps) {
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (steps[k].text != std::to_string(k + 1)) return false;
  return true;
}

}  // namespace

Survey survey(BoxLines& boxes, const std::vector<GivenPairs>& pairs, const std::string& pairs_name,
              const GivenTrees& trees, const std::string& nodes_name, Oddities& oddities) {
  const std::vector<GivenNodes>& nodes = trees.steps;
  BoxSurvey read = read_boxes(boxes, trees, !pairs_name.empty(), oddities);
  Survey result;
  result.steps = union_of(read.steps, pairs, pairs_name, oddities);
  check_alike(read.steps, pairs, pairs_name);
  check_steps(nodes, nodes_name, result.steps);
  note_gaps(result.steps, read.steps, boxes.table().name(), oddities);
  result.objects = read.objects;
  result.digits = digits_of(read, trees);
  if (result.digits && result.digits->boxes.coarse) note_coarse(boxes.table().name(), read.digits, oddities);
  if (result.digits && result.digits->nodes.coarse) note_coarse(nodes_name, trees.digits, oddities);
  result.rounding = read.writing.rounding();
  result.suspected = read.writing.suspected();
  result.suspected_from = read.writing.suspected_from();
  for (const GivenPairs& of_step : pairs)
    for (const GivenPair& pair : of_step.pairs) {
      for (const GivenId& id : {pair.a, pair.b}) check_sign(id, result.objects, pairs_name, pair.line);
      read.objects.insert(read.objects.end(), {pair.a, pair.b});
    }
  check_signs(nodes, nodes_name, result);
  for (const GivenNodes& of_step : nodes)
    for (const GivenNode& node : of_step.nodes)
      std::ranges::copy_if(node.objects, std::back_inserter(read.objects),
                           [&](const GivenId& object) { return result.is_object(object); });
  sort_unique(read.objects);
  std::vector<std::string> steps;
  if (!count_from_one(result.steps))
    for (const GivenStep& step : result.steps) steps.push_back(step.text);
  if (are_dense(read.objects)) read.objects.clear();
  result.names = GivenNames(std::move(read.objects), std::move(steps));
  return result;
}

}  // namespace kerf

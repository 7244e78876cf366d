#include "frames/advise/advice.h"

#include <algorithm>

#include "core/base/counted.h"
#include "frames/catalog/algorithm.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

/// Another one is worth a sentence if it is better by this factor, and not slower by that.
constexpr double kWorthSaying = 1.25;
constexpr double kNotWorthIt = 2;

std::string three_digits(double x) { return printed(x >= 100 ? "%.0f" : "%#.3g", x); }

std::string joined_names(const std::vector<Standing>& standings) {
  std::string text;
  for (const Standing& each : standings)
    text += (text.empty() ? "" : &each == &standings.back() ? " and " : ", ") + each.row.algorithm;
  return text;
}

bool is_from_library(const std::string& name) {
  const auto is_one = [](const auto& algorithm) { return algorithm && algorithm->origin == Origin::library; };
  return is_one(find_algorithm<2>(name)) || is_one(find_algorithm<3>(name));
}

/// `row` beside the fastest, round by round.
Standing beside(const BenchRow& row, const BenchRow& fastest) {
  const RoundRatio ratio = ratio_of_rounds(row, fastest);
  return {row, ratio, ratio.least <= 1, is_from_library(row.algorithm)};
}

std::string range_text(const Standing& standing) {
  return times_text(standing.times.least) + " to " + times_text(standing.times.most);
}

std::string duel_text(const Standing& fastest, const Standing& other, const std::string& what) {
  return fastest.row.algorithm + ": " + times_text(other.times.median) + " times as fast as " +
         other.row.algorithm + what + " (" + range_text(other) + " in the rounds), " +
         three_digits(step_milliseconds(fastest.row)) + " ms a step instead of " +
         three_digits(step_milliseconds(other.row)) + ".";
}

/// Whether one is the fastest, and by how much.
void say_fastest(const std::vector<Standing>& standings, std::vector<std::string>& sentences) {
  std::vector<Standing> level{standings.front()};
  const auto is_level = [](const Standing& each) { return each.is_level; };
  std::copy_if(standings.begin() + 1, standings.end(), std::back_inserter(level), is_level);
  if (level.size() > 1)
    sentences.push_back(joined_names(level) +
                        ": they do not differ by more than the noise, so choose by memory and worst step.");
  const auto next = std::find_if_not(standings.begin() + 1, standings.end(), is_level);
  if (next != standings.end()) sentences.push_back(duel_text(standings.front(), *next, ""));
  const auto library = std::find_if(standings.begin() + 1, standings.end(),
                                    [](const Standing& each) { return each.is_library; });
  if (library != standings.end() && library != next && !library->is_level && !standings.front().is_library)
    sentences.push_back(duel_text(standings.front(), *library, ", the fastest library"));
}

void say_wrong(const std::vector<BenchRow>& wrong, std::vector<std::string>& sentences) {
  for (const BenchRow& row : wrong)
    sentences.push_back(row.algorithm + ": not for this scene, it misses " + counted(row.missed, "pair") +
                        " and invents " + std::to_string(row.extra) + " in " + counted(row.steps, "step") +
                        ".");
}

/// What sets apart the only one that can be advised.
std::string why_alone(const Advice& advice) {
  if (advice.wrong.empty())
    return advice.left_out.empty() ? "the only one that was asked for" : "the only one that came to the end";
  return advice.left_out.empty() ? "the only one with the right pairs"
                                 : "the only one that came to the end with the right pairs";
}

std::string why_none(const Advice& advice) {
  if (advice.left_out.empty()) return "No broad phase reported the right pairs.";
  return "No broad phase came to the end with the right pairs; allow more --patience.";
}

/// What the fastest is not the best in.
void say_others(std::vector<Standing> standings, std::vector<std::string>& sentences) {
  const BenchRow fastest = standings.front().row;
  std::erase_if(standings, [](const Standing& each) { return each.times.median > kNotWorthIt; });
  const auto steadiest =
      std::ranges::min_element(standings, {}, [](const Standing& each) { return each.row.max_ns; });
  if (steadiest->row.max_ns * kWorthSaying < fastest.max_ns)
    sentences.push_back(steadiest->row.algorithm + ": its worst step takes " +
                        three_digits(steadiest->row.max_ns * fastest.cell.objects * 1e-6) + " ms, that of " +
                        fastest.algorithm + " " + three_digits(fastest.max_ns * fastest.cell.objects * 1e-6) +
                        "; choose it where no step may be late.");
  const auto smallest =
      std::ranges::min_element(standings, {}, [](const Standing& each) { return each.row.rss_bytes; });
  const auto bytes = [&](const BenchRow& row) {
    if (row.rss_bytes == 0) return std::string("too little to be measured");
    return three_digits(static_cast<double>(row.rss_bytes) / row.cell.objects) + " bytes an object";
  };
  if (static_cast<double>(smallest->row.rss_bytes) * kWorthSaying < static_cast<double>(fastest.rss_bytes))
    sentences.push_back(smallest->row.algorithm + ": takes the least memory, " + bytes(smallest->row) +
                        " instead of " + bytes(fastest) + ".");
}

}  // namespace

std::string times_text(double times) { return three_digits(times); }

double step_ns(const BenchRow& row) { return row.round_ns.empty() ? row.median_ns : median_round(row); }

double step_milliseconds(const BenchRow& row) { return step_ns(row) * row.cell.objects * 1e-6; }

Advice advise(const CellResult& cell) {
  Advice advice;
  advice.left_out = cell.gaps;
  std::vector<BenchRow> right;
  for (const BenchRow& row : cell.rows) {
    const bool is_complete =
        std::ranges::none_of(cell.gaps, [&](const BenchGap& gap) { return gap.algorithm == row.algorithm; });
    if (row.algorithm == "floor") continue;
    if (row.missed + row.extra > 0) {
      advice.wrong.push_back(row);
    } else if (is_complete && !row.round_ns.empty()) {
      right.push_back(row);
    }
  }
  std::ranges::stable_sort(right, {}, median_round);
  for (const BenchRow& row : right) advice.standings.push_back(beside(row, right.front()));
  if (!right.empty())
    std::ranges::stable_sort(advice.standings.begin() + 1, advice.standings.end(), {},
                             [](const Standing& each) { return each.times.median; });
  if (right.empty()) {
    advice.sentences.push_back(why_none(advice));
  } else if (right.size() == 1) {
    advice.sentences.push_back(right.front().algorithm + ": " + why_alone(advice) + ", " +
                               three_digits(step_milliseconds(right.front())) + " ms a step.");
  } else {
    say_fastest(advice.standings, advice.sentences);
    say_others(advice.standings, advice.sentences);
  }
  say_wrong(advice.wrong, advice.sentences);
  return advice;
}

}  // namespace kerf

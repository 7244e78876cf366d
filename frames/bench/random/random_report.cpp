#include "frames/bench/random/random_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "frames/bench/bench_report.h"
#include "frames/catalog/algorithm.h"
#include "frames/page/json.h"
#include "frames/support/machine.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

/// A ratio in a class of the histogram is at least this and below the next.
constexpr std::array<double, 11> kClasses{0, 0.5, 0.8, 0.95, 1.05, 1.25, 1.5, 2, 3, 5, 10};
constexpr double kSlower = 0.95;  ///< by more than 5 %

bool is_right(const BenchRow& row, const std::vector<BenchGap>& gaps) {
  const bool is_left_out =
      std::ranges::any_of(gaps, [&](const BenchGap& gap) { return gap.algorithm == row.algorithm; });
  return row.missed + row.extra == 0 && !row.round_ns.empty() && !is_left_out;
}

struct Judged {
  const RandomOutcome* outcome;
  RandomDuel duel;
};

/// Those that have both, the worst first.
std::vector<Judged> judged(const std::vector<RandomOutcome>& all) {
  std::vector<Judged> found;
  for (const RandomOutcome& outcome : all) {
    const RandomDuel duel = duel_of(outcome);
    if (duel.tree != nullptr && duel.other != nullptr) found.push_back({&outcome, duel});
  }
  std::ranges::sort(found, {}, [](const Judged& each) { return each.duel.ratio.median; });
  return found;
}

std::string histogram(const std::vector<Judged>& found) {
  std::string text;
  for (std::size_t k = 0; k < kClasses.size(); ++k) {
    const double end = k + 1 < kClasses.size() ? kClasses[k + 1] : INFINITY;
    const auto count = std::ranges::count_if(found, [&](const Judged& each) {
      return each.duel.ratio.median >= kClasses[k] && each.duel.ratio.median < end;
    });
    text += std::isinf(end) ? printed("  %5.2f and more  ", kClasses[k])
                            : printed("  %5.2f to %5.2f  ", kClasses[k], end);
    text +=
        printed("%4d  ", static_cast<int>(count)) + std::string(static_cast<std::size_t>(count), '#') + "\n";
  }
  return text;
}

/// Scenes in which the tree failed or reported wrong pairs.
std::string failures(const BenchRequest& request, const std::vector<RandomOutcome>& all) {
  std::string text;
  for (const RandomOutcome& outcome : all)
    if (duel_of(outcome).tree == nullptr)
      text += "THE TREE FAILED OR WAS WRONG: " + repeat_command(request, outcome.scene) + "\n";
  return text;
}

}  // namespace

RandomDuel duel_of(const RandomOutcome& outcome) {
  RandomDuel duel;
  for (const BenchRow& row : outcome.cell.rows) {
    if (row.algorithm == "floor" || !is_right(row, outcome.cell.gaps)) continue;
    if (row.algorithm == kTunedTree) {
      duel.tree = &row;
    } else if (duel.other == nullptr || median_round(row) < median_round(*duel.other)) {
      duel.other = &row;
    }
  }
  if (duel.tree != nullptr && duel.other != nullptr) duel.ratio = ratio_of_rounds(*duel.other, *duel.tree);
  return duel;
}

std::string repeat_command(const BenchRequest& request, const RandomScene& scene) {
  constexpr std::uint32_t kMost = 256000;
  std::string command = "kerf bench --random 1 --first " + std::to_string(scene.number) + " --seed " +
                        std::to_string(request.seed);
  if (request.most != kMost) command += " --most " + std::to_string(request.most);
  return command + request.measured_otherwise;
}

std::string random_heading() {
  return "SCENE DIM OBJECTS  PAIRS/OBJ     KERF  BEST OTHER                     RATIO  (ROUNDS)       ns an "
         "object and step";
}

std::string as_text(const RandomOutcome& outcome) {
  const RandomScene& scene = outcome.scene;
  const RandomDuel duel = duel_of(outcome);
  std::string text = printed("%5u %2dD %8u %10.2f ", scene.number, scene.dimension, scene.objects,
                             outcome.cell.properties.density);
  text += duel.tree == nullptr ? "   FAILED" : printed("%9.1f", duel.tree->median_ns);
  text += duel.other == nullptr
              ? printed("  %-24s", "none")
              : printed("  %-21s %8.1f", duel.other->algorithm.c_str(), duel.other->median_ns);
  if (duel.tree != nullptr && duel.other != nullptr)
    text += printed(" %7.2f  (%.2f-%.2f)", duel.ratio.median, duel.ratio.least, duel.ratio.most);
  return text + "  " + as_text(scene);
}

std::string random_summary(const BenchRequest& request, const std::vector<RandomOutcome>& all) {
  constexpr std::size_t kWorst = 10;
  const std::vector<Judged> found = judged(all);
  std::string text = failures(request, all);
  if (found.empty()) return text + "\nnothing to compare\n";
  double logarithms = 0;
  for (const Judged& each : found) logarithms += std::log(each.duel.ratio.median);
  const auto slower =
      std::ranges::count_if(found, [](const Judged& each) { return each.duel.ratio.median < kSlower; });
  text += printed(
      "\n%zu scenes: the fastest other over the tree, geometric mean %.2f, least %.2f; %d slower by more "
      "than 5 %%\n\n",
      found.size(), std::exp(logarithms / static_cast<double>(found.size())), found.front().duel.ratio.median,
      static_cast<int>(slower));
  text += histogram(found) + "\nTHE WORST\n";
  for (std::size_t k = 0; k < std::min(kWorst, found.size()); ++k)
    text += printed("  %.2f  ", found[k].duel.ratio.median) +
            repeat_command(request, found[k].outcome->scene) + "   # " + found[k].duel.other->algorithm +
            "; " + as_text(found[k].outcome->scene) + "\n";
  return text;
}

std::string as_json(const BenchRequest& request, const std::vector<RandomOutcome>& all, bool complete) {
  Json json;
  json["machine"] = describe_machine();
  json["settings"] = {{"random", request.random},   {"first", request.first},        {"most", request.most},
                      {"seed", request.seed},       {"rounds", request.rounds},      {"steps", request.steps},
                      {"warm_up", request.warm_up}, {"patience_s", request.patience}};
  json["scenes"] = Json::array();
  for (const RandomOutcome& outcome : all) {
    const RandomDuel duel = duel_of(outcome);
    Json item{{"drawn", as_json(outcome.scene)},
              {"text", as_text(outcome.scene)},
              {"measured", as_json(outcome.cell.properties)},
              {"command", repeat_command(request, outcome.scene)}};
    if (duel.tree != nullptr && duel.other != nullptr)
      item.update({{"ratio", duel.ratio.median},
                   {"least", duel.ratio.least},
                   {"most", duel.ratio.most},
                   {"other", duel.other->algorithm}});
    item["results"] = Json::array();
    for (const BenchRow& row : outcome.cell.rows) item["results"].push_back(as_json(row));
    item["gaps"] = Json::array();
    for (const BenchGap& gap : outcome.cell.gaps) item["gaps"].push_back(as_json(gap));
    json["scenes"].push_back(std::move(item));
  }
  json["complete"] = complete;
  return json_text(json) + "\n";
}

}  // namespace kerf

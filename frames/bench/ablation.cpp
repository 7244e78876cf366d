#include "frames/bench/ablation.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "frames/catalog/algorithm.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

bool is_same(const CellName& a, const CellName& b) {
  return a.scene == b.scene && a.dimension == b.dimension && a.objects == b.objects && a.threads == b.threads;
}

Earning earning_of(const BenchRow& base, const BenchRow& variant) {
  const RoundRatio ratio = ratio_of_rounds(variant, base);
  return {variant.cell, variant.algorithm, ratio.median - 1, ratio.least - 1, ratio.most - 1};
}

std::string line_of(const Earning& earning) {
  return printed("%-14s %dD %8u %2u %-44s %8.1f%% %8.1f%% %8.1f%%\n", earning.cell.scene.c_str(),
                 earning.cell.dimension, earning.cell.objects, earning.cell.threads, earning.variant.c_str(),
                 100 * earning.median, 100 * earning.least, 100 * earning.most);
}

}  // namespace

const std::vector<std::string>& ablated_policies() {
  static const std::vector<std::string> kPolicies{"byte_sweep=0:skin=0:stream_share=1",
                                                  "skin=0",
                                                  "stream_share=1",
                                                  "bulk_factor=0",
                                                  "restless=0",
                                                  "resting_pairs=0",
                                                  "leaf_boxes=0",
                                                  "rows=0",
                                                  "dense=0"};
  return kPolicies;
}

std::vector<std::string> ablation_algorithms() {
  std::vector<std::string> names{std::string(kTunedTree)};
  for (const std::string& off : ablated_policies()) names.push_back(names.front() + ":" + off);
  return names;
}

std::vector<Earning> earnings(const std::vector<BenchRow>& rows, const std::string& base) {
  std::vector<Earning> found;
  for (const BenchRow& variant : rows) {
    if (!variant.algorithm.starts_with(base + ":") || variant.round_ns.empty()) continue;
    const auto is_base = [&](const BenchRow& row) {
      return row.algorithm == base && is_same(row.cell, variant.cell) && !row.round_ns.empty();
    };
    const auto beside = std::ranges::find_if(rows, is_base);
    if (beside != rows.end()) found.push_back(earning_of(*beside, variant));
  }
  return found;
}

std::vector<Earning> best_earnings(const std::vector<Earning>& all) {
  std::vector<Earning> best;
  for (const Earning& earning : all) {
    const auto known = std::ranges::find(best, earning.variant, &Earning::variant);
    if (known == best.end()) {
      best.push_back(earning);
    } else if (earning.median > known->median) {
      *known = earning;
    }
  }
  return best;
}

std::string ablation_table(const std::vector<Earning>& all) {
  std::string text = "WHAT A POLICY EARNS: time without it over time with it, less 1, round by round\n";
  text +=
      "SCENE          DIM OBJECTS TH WITHOUT                                         MEDIAN    LEAST     "
      "MOST\n";
  for (const Earning& earning : all) text += line_of(earning);
  text += "\nEACH POLICY WHERE IT EARNS MOST\n";
  for (const Earning& earning : best_earnings(all)) text += line_of(earning);
  return text;
}

nlohmann::ordered_json as_json(const Earning& earning) {
  return {{"scene", earning.cell.scene},     {"dim", earning.cell.dimension},
          {"objects", earning.cell.objects}, {"threads", earning.cell.threads},
          {"variant", earning.variant},      {"median", earning.median},
          {"least", earning.least},          {"most", earning.most}};
}

}  // namespace kerf

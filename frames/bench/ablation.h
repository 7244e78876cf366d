#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "frames/bench/bench_row.h"

namespace kerf {

/// What a policy of the tuned tree earns in a cell: the time without it over the time with it, less 1, of
/// rounds that were measured in turns.
struct Earning {
  CellName cell;
  std::string variant;  ///< the tree without the policy, as `kerf bench --algorithms` names it
  double median = 0;    ///< over the rounds
  double least = 0;
  double most = 0;
};

/// The policies, each as the parameters that switch it off: "skin=0", ...
const std::vector<std::string>& ablated_policies();

/// The tuned tree, then the tuned tree without each policy: names for `kerf bench --algorithms`.
std::vector<std::string> ablation_algorithms();

/// What each variant's policy earns in each cell that has a row of the base. Rows of algorithms that are no
/// variant of `base` ("kerf" and "kerf:K=V...") are passed over.
std::vector<Earning> earnings(const std::vector<BenchRow>& rows, const std::string& base);

/// For each variant the cell in which its policy earns most, in the order of the variants.
std::vector<Earning> best_earnings(const std::vector<Earning>& all);

/// A heading, a line for each earning, and a line for each policy with its best cell.
std::string ablation_table(const std::vector<Earning>& all);
nlohmann::ordered_json as_json(const Earning& earning);

}  // namespace kerf

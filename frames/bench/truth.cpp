#include "frames/bench/truth.h"

#include <algorithm>
#include <stdexcept>

#include "core/broad_phase/all_pairs.h"
#include "core/broad_phase/columns.h"
#include "core/broad_phase/sort_and_sweep.h"
#include "core/bsp/bsp.h"

namespace kerf {
namespace {

constexpr std::size_t kMostTested = 5000;   ///< objects tested each against each
constexpr std::size_t kMostSwept = 100000;  ///< objects that are sorted and swept

template <int D>
std::vector<Pair> pairs_by(BroadPhase<D>& oracle, std::span<const Box<D>> boxes, std::uint32_t moving) {
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (is_absent(boxes[k])) continue;
    const Status status = oracle.insert({k}, boxes[k], k < moving ? Mobility::moving : Mobility::fixed);
    if (status != Status::ok) throw std::logic_error("the scene has a bad box");
  }
  oracle.step();
  return {oracle.pairs().begin(), oracle.pairs().end()};
}

template <int D>
std::unique_ptr<BroadPhase<D>> make_oracle(std::size_t objects) {
  if (objects <= kMostTested) return std::make_unique<AllPairs<D>>();
  if (objects <= kMostSwept) return std::make_unique<SortAndSweep<D>>();
  return std::make_unique<Columns<D>>();
}

template <int D>
std::unique_ptr<BroadPhase<D>> make_other(std::size_t objects) {
  if (objects <= kMostSwept) return std::make_unique<Columns<D>>();
  return std::make_unique<Bsp<D>>(tuned_config());
}

}  // namespace

template <int D>
std::vector<Pair> agreed_pairs(BroadPhase<D>& oracle, BroadPhase<D>& other, std::span<const Box<D>> boxes,
                               std::uint32_t moving) {
  std::vector<Pair> pairs = pairs_by(oracle, boxes, moving);
  if (truth_of(pairs) != truth_of(pairs_by(other, boxes, moving)))
    throw std::logic_error("two algorithms of ours that should be exact disagree");
  return pairs;
}

template <int D>
std::vector<Pair> true_pairs(std::span<const Box<D>> boxes, std::uint32_t moving) {
  return pairs_by(*make_oracle<D>(boxes.size()), boxes, moving);
}

template <int D>
std::vector<Pair> confirmed_pairs(std::span<const Box<D>> boxes, std::uint32_t moving) {
  return agreed_pairs<D>(*make_oracle<D>(boxes.size()), *make_other<D>(boxes.size()), boxes, moving);
}

Difference compare(std::span<const Pair> found, std::vector<Pair> truth) {
  std::vector<Pair> reported;
  reported.reserve(found.size());
  for (const Pair& pair : found) reported.push_back(make_pair(pair.a, pair.b));
  std::sort(reported.begin(), reported.end());
  std::sort(truth.begin(), truth.end());
  Difference difference;
  auto next = truth.begin();
  for (const Pair& pair : reported) {
    for (; next != truth.end() && *next < pair; ++next) ++difference.missed;
    if (next != truth.end() && *next == pair) {
      ++next;
    } else {
      ++difference.extra;
    }
  }
  difference.missed += static_cast<std::uint64_t>(truth.end() - next);
  return difference;
}

template std::vector<Pair> agreed_pairs<2>(BroadPhase<2>&, BroadPhase<2>&, std::span<const Box<2>>,
                                           std::uint32_t);
template std::vector<Pair> agreed_pairs<3>(BroadPhase<3>&, BroadPhase<3>&, std::span<const Box<3>>,
                                           std::uint32_t);
template std::vector<Pair> true_pairs<2>(std::span<const Box<2>>, std::uint32_t);
template std::vector<Pair> true_pairs<3>(std::span<const Box<3>>, std::uint32_t);
template std::vector<Pair> confirmed_pairs<2>(std::span<const Box<2>>, std::uint32_t);
template std::vector<Pair> confirmed_pairs<3>(std::span<const Box<3>>, std::uint32_t);

}  // namespace kerf

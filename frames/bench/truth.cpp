#include "frames/bench/truth.h"

#include <algorithm>
#include <stdexcept>

#include "core/broad_phase/brute_force.h"
#include "frames/rivals/rival.h"

namespace kerf {
namespace {

constexpr std::size_t kBruteForce = 2000;  ///< objects that brute force is used for

template <int D>
std::unique_ptr<BroadPhase<D>> make_oracle(std::size_t count) {
  if (count <= kBruteForce) return std::make_unique<BruteForce<D>>();
  return find_rival<D>("cgal-box-intersection")->make({}, Intake::checked);
}

}  // namespace

template <int D>
std::vector<Pair> true_pairs(std::span<const Box<D>> boxes, std::uint32_t moving) {
  const auto oracle = make_oracle<D>(boxes.size());
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    const Status status = oracle->insert({k}, boxes[k], k < moving ? Mobility::moving : Mobility::fixed);
    if (status != Status::ok) throw std::runtime_error("the scene has a bad box");
  }
  oracle->step();
  return {oracle->pairs().begin(), oracle->pairs().end()};
}

Difference compare(std::span<const Pair> found, std::vector<Pair> truth) {
  std::vector<Pair> told;
  told.reserve(found.size());
  for (const Pair& pair : found) told.push_back(make_pair(pair.a, pair.b));
  std::sort(told.begin(), told.end());
  std::sort(truth.begin(), truth.end());
  Difference difference;
  auto next = truth.begin();
  for (const Pair& pair : told) {
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

template std::vector<Pair> true_pairs<2>(std::span<const Box<2>>, std::uint32_t);
template std::vector<Pair> true_pairs<3>(std::span<const Box<3>>, std::uint32_t);

}  // namespace kerf

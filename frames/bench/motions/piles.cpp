#include "frames/bench/motions/motions.h"
#include "frames/bench/motions/pile.h"

namespace kerf {

template <int D>
std::unique_ptr<Motion<D>> make_falling(std::uint32_t count, std::uint64_t seed) {
  constexpr PileRules kRules{.in_air = 1.0 / 3, .heaps = 4};
  return std::make_unique<Pile<D>>(count, seed, kRules);
}

template <int D>
std::unique_ptr<Motion<D>> make_settled(std::uint32_t count, std::uint64_t seed) {
  constexpr PileRules kRules{.slides_one_in = 2000};
  return std::make_unique<Pile<D>>(count, seed, kRules);
}

template <int D>
std::unique_ptr<Motion<D>> make_buckets(std::uint32_t count, std::uint64_t seed) {
  constexpr PileRules kRules{.in_air = 0.25, .buckets = 4};
  return std::make_unique<Pile<D>>(count, seed, kRules);
}

template std::unique_ptr<Motion<2>> make_falling<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_falling<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_settled<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_settled<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_buckets<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_buckets<3>(std::uint32_t, std::uint64_t);

}  // namespace kerf

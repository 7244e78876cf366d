#include "frames/report/total_cost.h"

#include <algorithm>

#include "core/broad_phase/all_pairs.h"
#include "frames/bench/truth.h"
#include "frames/report/figures.h"
#include "frames/rivals/step_timer.h"

namespace kerf {

template <int D>
struct TotalCost<D>::Figures {
  StepTimes broad;
  StepTimes narrow;
  StepTimes total;
  std::uint64_t candidates = 0;
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;
};

template <int D>
TotalCost<D>::TotalCost(const Take<D>& take, const Poll& poll) : take_(&take) {
  for (const Shape<D>& shape : take.shapes) probe_.add(shape);
  AllPairs<D> oracle;
  begin(oracle);
  for (std::size_t step = 0; step < take.poses.size(); ++step) {
    poll();
    place(step);
    for (std::uint32_t k = 0; k < take.shapes.size(); ++k)
      static_cast<void>(oracle.move({k}, probe_.volume(VolumeKind::box, {k}).box));
    oracle.step();
    contacts_.push_back(test(oracle));
    std::sort(contacts_.back().begin(), contacts_.back().end());
  }
}

template <int D>
void TotalCost<D>::place(std::size_t step) {
  for (std::uint32_t k = 0; k < take_->shapes.size(); ++k) probe_.place({k}, take_->poses[step][k]);
}

template <int D>
void TotalCost<D>::begin(BroadPhase<D>& broad_phase) {
  place(0);
  for (std::uint32_t k = 0; k < take_->shapes.size(); ++k)
    static_cast<void>(
        broad_phase.insert({k}, probe_.volume(broad_phase.volume_kind(), {k}), take_->mobility[k]));
  broad_phase.step();
}

/// The candidates that touch.
template <int D>
std::vector<Pair> TotalCost<D>::test(const BroadPhase<D>& broad_phase) const {
  std::vector<Pair> touching;
  for (const Pair& pair : broad_phase.pairs())
    if (probe_.depth(pair)) touching.push_back(make_pair(pair.a, pair.b));
  return touching;
}

/// Volumes are made before the clock runs: their cost belongs to another section.
template <int D>
void TotalCost<D>::play(BroadPhase<D>& broad_phase, Figures& figures, bool judge, const Poll& poll) {
  figures.broad.restart();
  figures.narrow.restart();
  figures.total.restart();
  begin(broad_phase);
  std::vector<Volume<D>> volumes(take_->shapes.size());
  for (std::size_t step = 1; step < take_->poses.size(); ++step) {
    poll();
    place(step);
    for (std::uint32_t k = 0; k < volumes.size(); ++k)
      volumes[k] = probe_.volume(broad_phase.volume_kind(), {k});
    const StepTimer broad(true);
    for (std::uint32_t k = 0; k < volumes.size(); ++k)
      if (take_->mobility[k] == Mobility::moving) static_cast<void>(broad_phase.move({k}, volumes[k]));
    broad_phase.step();
    const auto broad_ns = static_cast<double>(broad.nanoseconds());
    const StepTimer narrow(true);
    const std::vector<Pair> touching = test(broad_phase);
    const auto narrow_ns = static_cast<double>(narrow.nanoseconds());
    figures.broad.add(broad_ns);
    figures.narrow.add(narrow_ns);
    figures.total.add(broad_ns + narrow_ns);
    if (!judge) continue;
    figures.candidates += broad_phase.pairs().size();
    figures.contacts += contacts_[step].size();
    figures.missed += compare(touching, contacts_[step]).missed;
  }
}

template <int D>
Json TotalCost<D>::run(const std::function<std::unique_ptr<BroadPhase<D>>()>& make, std::uint32_t rounds,
                       const Poll& poll) {
  Figures figures;
  for (std::uint32_t round = 0; round < rounds; ++round) play(*make(), figures, round == 0, poll);
  const auto objects = static_cast<double>(take_->shapes.size());
  const Times total = figures.total.over(objects);
  const double contacts = std::max<double>(1, static_cast<double>(figures.contacts));
  return {{"broad_ns", figures.broad.over(objects).mean},
          {"narrow_ns", figures.narrow.over(objects).mean},
          {"total_ns", total.mean},
          {"total_ns_low", total.round_low},
          {"total_ns_high", total.round_high},
          {"p99_ns", total.p99},
          {"max_ns", total.max},
          {"candidates", figures.candidates},
          {"contacts", figures.contacts},
          {"missed", figures.missed},
          {"missed_share", static_cast<double>(figures.missed) / contacts},
          {"candidates_per_contact", static_cast<double>(figures.candidates) / contacts}};
}

template class TotalCost<2>;
template class TotalCost<3>;

}  // namespace kerf

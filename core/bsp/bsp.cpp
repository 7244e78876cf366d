#include "core/bsp/bsp.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/tuning.h"
#include "core/bsp/common_motion.h"
#include "core/tree/hash.h"
#include "core/tree/statistics_of.h"

namespace kerf {

template <int D, class Trace>
Bsp<D, Trace>::Bsp(const Config& config, VolumeKind kind)
    : config_(config), tree_(make_projector<D>(config, kind)), requests_(kind) {
  time_phases(Trace::kEnabled);
}

template <int D, class Trace>
void Bsp<D, Trace>::set_config(const Config& config) {
  check(config);
  if (config.directions != config_.directions || config.seed != config_.seed)
    throw std::invalid_argument("directions and seed cannot change while the tree lives: make a new one");
  config_ = config;
}

template <int D, class Trace>
void Bsp<D, Trace>::decide(std::vector<Decision> decisions) {
  if (!Trace::kEnabled) throw std::invalid_argument("without a trace events have no numbers to decide about");
  for (const Decision& decision : decisions)
    if (decision.plane &&
        (decision.plane->direction >= tree_.directions().size() || !std::isfinite(decision.plane->offset)))
      throw std::invalid_argument("e" + std::to_string(decision.event) + ": there is no direction " +
                                  std::to_string(decision.plane->direction) + " with offset " +
                                  std::to_string(decision.plane->offset));
  reporter_.decide(std::move(decisions));
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  const DefaultFloats floats;
  return requests_.insert(object, box, mobility, receiver());
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  const DefaultFloats floats;
  return requests_.insert(object, volume, mobility, receiver());
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Box<D>& box) {
  return move_many({&object, 1}, {&box, 1});
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Volume<D>& volume) {
  const DefaultFloats floats;
  return requests_.move(object, volume, receiver());
}

template <int D, class Trace>
Status Bsp<D, Trace>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  if (objects.size() != boxes.size())
    throw std::invalid_argument(std::to_string(boxes.size()) + " boxes for " +
                                std::to_string(objects.size()) + " objects: there must be one for each");
  const UsualComparisons comparisons;
  if (objects.size() < tuning::kFewThings) return requests_.move_many(objects, boxes, receiver());
  const auto start = threads_.now();
  const Status first = requests_.move_many(objects, boxes, receiver());
  threads_.end_requests(start);
  return first;
}

template <int D, class Trace>
Status Bsp<D, Trace>::remove(ObjectId object) {
  return requests_.remove(object, receiver());
}

template <int D, class Trace>
void Bsp<D, Trace>::step() {
  const auto start = threads_.now();
  if (is_calm()) {
    step_in_rows();
  } else {
    const DefaultFloats floats;
    adapt();
    find_pairs();
    // Often more pairs follow, and memory lies behind these by then: they would move, and leave a hole.
    if (step_ == 1) pairs_.reserve(pairs_.size() / 2);
    clock_.end();
  }
  threads_.end_step(start, modes_.mode(), tree_.objects());
}

/// Whether a step would change nothing but boxes, the rows of pairs, and its number: little or nothing moves
/// in a small world whose pairs are rows of bits. The fixed cost of a step would be most of what it takes.
template <int D, class Trace>
bool Bsp<D, Trace>::is_calm() const {
  if (Trace::kEnabled || clock_.is_on()) return false;  // a trace or a clock needs all phases
  return modes_.has_settled_on_rows() && config_.skin > 0 && row_tests() <= tuning::kFewTests &&
         requests_.are_moves() && swept_.has_rows(tree_.table) && scheduler_.is_idle(tree_, config_);
}

/// A calm step: the same as a whole one.
template <int D, class Trace>
void Bsp<D, Trace>::step_in_rows() {
  ++step_;
  placed_ = 0;
  if (requests_.given() == 0) return swept_.find_in_rows(tree_.table, pairs_);  // they may be given away
  const DefaultFloats floats;
  swept_.begin_step(tree_, requests_.changed(), true);
  SweptStep<D>::move_in_root(context());
  requests_.finish_step({}, threads_.pool());
  swept_.find_in_rows(tree_.table, pairs_);
}

/// Without its pairs nothing of a leaf can be kept.
template <int D, class Trace>
void Bsp<D, Trace>::step_unswept() {
  const DefaultFloats floats;
  adapt();
  pairs_.clear();
  kept_.forget_pairs();
  swept_.forget_pairs();
  clock_.end();
}

/// All of a step but its pairs.
template <int D, class Trace>
void Bsp<D, Trace>::adapt() {
  ++step_;
  reporter_.begin_step(step_);
  begin(Phase::place);
  place();
  begin(Phase::sort);
  sort_leaves();
  begin(Phase::schedule);
  scheduler_.traverse(tree_, config_, step_, reporter_);
  begin(Phase::operate);
  scheduler_.process(tree_, config_, step_, reporter_);
  sort_leaves();
  begin(Phase::sweep);
}

/// The motion by which the tree comes along. The paper's configuration knows none.
template <int D, class Trace>
std::optional<Vector<D>> Bsp<D, Trace>::common_motion(std::uint64_t row_tests) const {
  if (!config_.byte_sweep || !(config_.skin > 0) || modes_.mode() == Mode::ordered) return std::nullopt;
  if (modes_.mode() == Mode::swept && row_tests <= tuning::kRowTests) return std::nullopt;
  return kerf::common_motion(requests_, tree_.table, modes_.mode() == Mode::kept);
}

/// How many boxes rows of bits would compare for what was requested: endlessly many where there are none. As
/// all that decides how objects are placed, it is the same in a run that goes on from a keyframe.
template <int D, class Trace>
std::uint64_t Bsp<D, Trace>::row_tests() const {
  const std::size_t objects = requests_.latest().bound();
  const bool may_be = config_.byte_sweep && config_.rows && requests_.kind() == VolumeKind::box &&
                      objects <= tuning::kMostRows && tree_[tree_.root()].is_leaf();
  return may_be ? requests_.given() * objects : std::numeric_limits<std::uint64_t>::max();
}

/// Samples what the present mode needs to know. A shift says nothing of how objects move beside it.
template <int D, class Trace>
Evidence Bsp<D, Trace>::evidence(std::uint64_t row_tests, bool is_shift) const {
  Evidence evidence;
  evidence.shift = is_shift;
  evidence.bytes = config_.byte_sweep;
  evidence.skins = config_.skin > 0 && requests_.kind() == VolumeKind::box;
  evidence.rows = row_tests <= tuning::kFewTests;
  if (!evidence.bytes || !evidence.skins) return evidence;
  if (modes_.mode() == Mode::swept && !is_shift && !evidence.rows) {
    const auto count = row_tests <= tuning::kRowTests ? tuning::kMotionSampleInRows : tuning::kMotionSample;
    evidence.motions = sample_motions(requests_, tree_.table, config_, step_, count);
  } else if (modes_.mode() == Mode::kept && !modes_.regrets()) {
    evidence.leaving = sample_leaving(requests_, config_);
    if (is_shift) evidence.leaving.motions = {};
  }
  return evidence;
}

template <int D, class Trace>
void Bsp<D, Trace>::choose_mode(std::uint64_t row_tests, bool is_shift) {
  modes_.decide(evidence(row_tests, is_shift));
  if (modes_.taken() == nullptr) return;
  kept_.forget_pairs();
  if (modes_.mode() != Mode::swept) swept_.forget();
  requests_.end_following();
}

/// Brings the tree's entries up to date with the requests, in the mode that they call for.
template <int D, class Trace>
void Bsp<D, Trace>::place() {
  const Mode before = modes_.mode();
  const std::uint64_t tests = row_tests();
  const std::optional<Vector<D>> shift = common_motion(tests);
  choose_mode(tests, shift.has_value());
  const bool rows = modes_.mode() == Mode::swept && tests <= tuning::kRowTests;
  swept_.begin_step(tree_, requests_.changed(), rows);
  placed_ = place_after(before, context(shift), rows);
  requests_.finish_step(modes_.mode() == Mode::kept ? kept_.skins() : std::span<const Skin>{},
                        threads_.pool());
}

/// Places the objects after a step of mode `before`, and returns how many. `rows`: rows of bits pay.
template <int D, class Trace>
std::uint64_t Bsp<D, Trace>::place_after(Mode before, const StepContext<D>& step, bool rows) {
  const Mode mode = modes_.mode();
  const bool keeps_on = mode == Mode::kept && before == Mode::kept;
  if (step.shift && !keeps_on) shift_planes(tree_, *step.shift);
  if (mode == Mode::kept) {
    const std::uint64_t placed = kept_.place(step, !keeps_on, reporter_);
    modes_.count_cost(kept_.cost());
    return placed;
  }
  if (rows && before == Mode::swept && requests_.are_moves()) {
    SweptStep<D>::move_in_root(step);
    return 0;
  }
  if (before == Mode::kept || step.shift ||
      (mode == Mode::swept && requests_.changed_exceed(config_.stream_share)))
    return swept_.place_all(step, before, mode, reporter_);
  return OrderedStep<D>::place(step, reporter_);
}

template <int D, class Trace>
void Bsp<D, Trace>::sort_leaves() {
  if (modes_.mode() == Mode::ordered) OrderedStep<D>::sort(tree_);
}

template <int D, class Trace>
void Bsp<D, Trace>::find_pairs() {
  if (modes_.mode() == Mode::kept) return kept_.find(context(), pairs_);
  if (swept_.has_rows(tree_.table)) return swept_.find_in_rows(tree_.table, pairs_);
  const bool ordered = modes_.mode() == Mode::ordered;
  pairs_.clear();
  memory_.leaf_pass.run(
      tree_, threads_.pool(), config_.dense,
      [this, ordered](NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) {
        ordered ? OrderedStep<D>::find(tree_, leaf, scratch, pairs)
                : swept_.find(tree_, leaf, scratch, pairs);
      },
      pairs_);
  swept_.end_step(tree_.table, std::as_const(pairs_).all());
}

template <int D, class Trace>
void Bsp<D, Trace>::begin(Phase phase) {
  clock_.begin(phase);
  reporter_.report([&] { return PhaseBegan{phase}; });
}

template <int D, class Trace>
Statistics Bsp<D, Trace>::statistics() const {
  Statistics s = statistics_of(tree_, scheduler_);
  s.placed = placed_;
  s.phase_seconds = clock_.seconds();
  return s;
}

template <int D, class Trace>
std::uint64_t Bsp<D, Trace>::state_hash() const {
  return scheduler_.mix_into(hash(tree_));
}

#define KERF_INSTANTIATE(D, TRACE) template class Bsp<D, TRACE>;
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf

#include "core/bsp/bsp.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/bsp/ordered_sweep.h"
#include "core/objects/skin.h"
#include "core/tree/hash.h"
#include "core/tree/subtree.h"

namespace kerf {
namespace {

/// Renews and orders the lists of the leaves that something changed.
template <int D>
void sort_leaves(Tree<D>& tree) {
  for_each_node(tree, tree.root(), [&tree](NodeId id) {
    if (!tree[id].unsorted) return;
    renew_keys(tree, id);
    sort_entries(tree[id].entries);
    tree[id].unsorted = false;
  });
}

/// Position `k` of a sample of `count` things, which no order of theirs can deceive.
std::size_t sample_place(std::uint32_t k, std::size_t count) {
  constexpr std::uint32_t kGolden = 0x9E3779B9U;
  return (std::uint64_t{k * kGolden} * count) >> 32U;
}

/// The motions of some objects, one by one.
class MotionSample {
 public:
  template <int D>
  void add(const Box<D>& box, const Box<D>& before) {
    if (is_fast(box, before)) {
      ++sum_.fast;
    } else {
      sum_.speed += relative_speed(box, before);
    }
    ++count_;
  }
  [[nodiscard]] Motions motions() const {
    return count_ == 0 ? Motions{} : Motions{sum_.speed / count_, sum_.fast / count_};
  }

 private:
  Motions sum_;
  float count_ = 0;
};

}  // namespace

template <int D, class Trace>
Bsp<D, Trace>::Bsp(const Config& config, VolumeKind kind)
    : config_(config), tree_(make_projector<D>(config, kind)), latest_(kind) {}

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

/// Remembers that an object changed, unless the request was refused.
template <int D, class Trace>
Status Bsp<D, Trace>::note(ObjectId object, Status status) {
  if (is_refused(status)) return status;
  only_moves_ = false;
  attention_.resize(latest_.bound(), kUnplaced);
  std::uint8_t& attention = attention_[object.index()];
  if ((attention & kChanging) != 0) return status;
  attention |= kChanging;
  changed_.push_back(object);
  if (mode_ == Mode::kept) before_.push_back(latest_.packed(object));
  return status;
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  return note(object, latest().insert(object, box, mobility));
}

template <int D, class Trace>
Status Bsp<D, Trace>::insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  return note(object, latest().insert(object, volume, mobility));
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Box<D>& box) {
  return move_many({&object, 1}, {&box, 1});
}

template <int D, class Trace>
Status Bsp<D, Trace>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  const bool keeps = mode_ == Mode::kept;
  ObjectId* const changed = changed_.reserve(objects.size());
  PackedBox<D>* const before = keeps ? before_.reserve(objects.size()) : nullptr;
  std::uint32_t* const left_over = left_over_.reserve(objects.size());
  exchange_.end(latest_, tree_.table, objects, *pool_);
  Status first = Status::ok;
  const auto keep_first = [&first](Status status) {
    if (first == Status::ok) first = status;
  };
  if (latest_.kind() != VolumeKind::box) {
    for (std::size_t k = 0; k < objects.size(); ++k)
      keep_first(note(objects[k], latest_.move(objects[k], boxes[k])));
    return first;
  }
  const MoveAnswer answer = move_boxes<D>(
      {objects, boxes, latest_.packed(), attention_,
       keeps ? std::as_const(tree_.table).packed().data() : nullptr, changed, before, left_over},
      *pool_);
  changed_.commit(answer.changed);
  if (keeps) before_.commit(answer.changed);
  left_over_.commit(answer.left_over);
  for (const std::uint32_t k : left_over_.all()) {
    if (objects[k].index() < attention_.size())
      attention_[objects[k].index()] &= static_cast<std::uint8_t>(~kWaiting);
    keep_first(note(objects[k], latest_.move(objects[k], boxes[k])));
  }
  left_over_.clear();
  return first;
}

template <int D, class Trace>
Status Bsp<D, Trace>::move(ObjectId object, const Volume<D>& volume) {
  if (latest_.kind() == VolumeKind::box && volume.kind == VolumeKind::box) return move(object, volume.box);
  return note(object, latest().move(object, volume));
}

template <int D, class Trace>
Status Bsp<D, Trace>::remove(ObjectId object) {
  return note(object, latest().remove(object));
}

template <int D, class Trace>
void Bsp<D, Trace>::step() {
  adapt();
  sweep();
  end_phase();
}

/// Without its pairs nothing of a leaf can be kept.
template <int D, class Trace>
void Bsp<D, Trace>::step_unswept() {
  adapt();
  pairs_.clear();
  kept_.clear();
  end_phase();
}

/// All of a step up to the sweep.
template <int D, class Trace>
void Bsp<D, Trace>::adapt() {
  ++step_;
  reporter_.begin_step(step_);
  begin(Phase::place);
  place();
  begin(Phase::sort);
  if (mode_ == Mode::ordered) sort_leaves(tree_);
  begin(Phase::schedule);
  scheduler_.traverse(tree_, config_, step_, reporter_);
  begin(Phase::operate);
  scheduler_.process(tree_, config_, step_, reporter_);
  if (mode_ == Mode::ordered) sort_leaves(tree_);
  begin(Phase::sweep);
}

template <int D, class Trace>
void Bsp<D, Trace>::choose_mode() {
  if (!config_.byte_sweep) return enter(Mode::ordered);
  if (config_.skin == 0 || latest_.kind() != VolumeKind::box) {
    keep_or_sweep_ = {};
    return enter(Mode::swept);
  }
  if (mode_ == Mode::ordered) {
    keep_or_sweep_ = {};
  } else if (mode_ == Mode::kept) {
    if (keep_or_sweep_.keeps()) keep_or_sweep_.kept(who_leaves(), D);  // else too much was swept all the same
  } else {
    keep_or_sweep_.swept(motions_of_sample(), D);
  }
  enter(keep_or_sweep_.keeps() ? Mode::kept : Mode::swept);
}

/// Others in each step: a sample that does not show how many are fast must not be believed twice.
template <int D, class Trace>
Motions Bsp<D, Trace>::motions_of_sample() const {
  MotionSample sample;
  const auto first = static_cast<std::uint32_t>(kSample) * step_;
  for (std::uint32_t k = 0; k < std::min<std::size_t>(kSample, tree_.table.bound()); ++k) {
    const ObjectId object{static_cast<std::uint32_t>(sample_place(first + k, tree_.table.bound()))};
    if (tree_.table.is_placed(object) && latest_.is_placed(object))
      sample.add(latest_.box(object), tree_.table.box(object));
  }
  return sample.motions();
}

/// Whether most objects of a sample are so far from where they were that few of them stay in their leaves.
template <int D, class Trace>
bool Bsp<D, Trace>::most_jump() const {
  constexpr std::uint32_t kFew = 64;
  constexpr float kSizes = 6;
  std::uint32_t jumped = 0;
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < std::min<std::size_t>(kFew, tree_.table.bound()); ++k) {
    const ObjectId object{static_cast<std::uint32_t>(sample_place(k, tree_.table.bound()))};
    if (!tree_.table.is_placed(object)) continue;
    const auto [size, speed] = size_and_speed(latest_.box(object), tree_.table.box(object));
    jumped += speed > kSizes * size ? 1 : 0;
    ++count;
  }
  return 2 * jumped > count;
}

/// How fast they are is looked at, in a sample of them, only if there are many.
template <int D, class Trace>
Leaving Bsp<D, Trace>::who_leaves() const {
  Leaving leaving;
  leaving.share = static_cast<float>(changed_.size()) / static_cast<float>(latest_.size() + 1);
  if (leaving.share <= KeepOrSweep::kHot) return leaving;
  const auto count = static_cast<std::uint32_t>(std::min(kSample, changed_.size()));
  MotionSample sample;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::size_t at = sample_place(k, changed_.size());
    const ObjectId object = changed_.all()[at];
    if (latest_.is_placed(object)) sample.add(latest_.box(object), before_.all()[at].unpack());
  }
  leaving.motions = sample.motions();
  return leaving;
}

template <int D, class Trace>
void Bsp<D, Trace>::enter(Mode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  kept_.clear();
  if (mode != Mode::swept) leaf_boxes_ = {};
  for (std::uint8_t& attention : attention_) attention &= static_cast<std::uint8_t>(~kSilent);
}

template <int D, class Trace>
void Bsp<D, Trace>::sweep() {
  if (mode_ == Mode::kept) return kept_.find(tree_, latest_, skins_, leaf_pass_, *pool_, pairs_);
  pairs_.clear();
  leaf_pass_.run(
      tree_, *pool_,
      [this](NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) { sweep(leaf, scratch, pairs); },
      pairs_);
}

/// The list of a leaf lies along its parent's normal. Where the paper's criteria let a leaf grow without end,
/// that may be an axis on which all boxes coincide (HARD_CASES.md, S6): such a leaf is swept by bytes along
/// the best axis, whatever the policy.
template <int D, class Trace>
void Bsp<D, Trace>::sweep(NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) {
  constexpr std::size_t kLongList = 512;
  if (mode_ == Mode::ordered && tree_[leaf].entries.size() <= kLongList)
    return sweep_leaf(tree_.table, tree_[leaf], scratch.ordered, pairs);
  const std::size_t begin = pairs.size();
  sweep_bytes(leaf, scratch, pairs);
  if (latest_.kind() != VolumeKind::box) drop_separated(tree_.table, begin, pairs);
}

template <int D, class Trace>
void Bsp<D, Trace>::sweep_bytes(NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs) {
  if (!leaf_boxes_.has(tree_, leaf)) {
    view_leaf(tree_, tree_.table, leaf, scratch.view);
    return scratch.byte_sweep.find(scratch.view, pairs);
  }
  view_all_but_boxes(tree_, tree_.table, leaf, scratch.view);
  leaf_boxes_.swap(leaf, scratch.view.boxes);
  scratch.byte_sweep.find(scratch.view, pairs);
  leaf_boxes_.swap(leaf, scratch.view.boxes);
}

template <int D, class Trace>
void Bsp<D, Trace>::begin(Phase phase) {
  end_phase();
  phase_ = phase;
  reporter_.report([&] { return PhaseBegan{phase}; });
}

template <int D, class Trace>
void Bsp<D, Trace>::end_phase() {
  const auto now = std::chrono::steady_clock::now();
  phase_seconds_[static_cast<std::size_t>(phase_)] =
      std::chrono::duration<double>(now - phase_start_).count();
  phase_start_ = now;
}

template <int D, class Trace>
Statistics Bsp<D, Trace>::statistics() const {
  Statistics s;
  s.objects = tree_.objects();
  s.entries = tree_.entries();
  s.redundancy = s.objects == 0 ? 0 : static_cast<double>(s.entries) / s.objects - 1;
  for_each_node(tree_, tree_.root(), [&](NodeId id) {
    if (!tree_[id].is_leaf()) return;
    ++s.leaves;
    s.height = std::max(s.height, tree_[id].depth);
  });
  s.operators = scheduler_.acted();
  s.refused = scheduler_.refused();
  s.deferred = scheduler_.pending();
  s.placed = placed_;
  s.phase_seconds = phase_seconds_;
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

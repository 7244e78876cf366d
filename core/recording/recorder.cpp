#include "core/recording/recorder.h"

#include <algorithm>

#include "core/trace/event_facts.h"

namespace kerf {
namespace {

/// Refused requests did nothing and are not written down.
bool counts(Status status) { return !is_refused(status); }

/// The volume that a table of boxes or other volumes stores for one of the wrong kind: a box, or a volume
/// that cannot be placed.
template <int D>
Box<D> box_of(const Volume<D>& volume) {
  return is_ordered(volume) ? volume.box : Box<D>::empty();
}

}  // namespace

template <int D>
Recorder<D>::Recorder(Bsp<D, EventLog>& tree, const std::filesystem::path& path, const RecordingInfo& info)
    : tree_(tree), info_(info), writer_(path, info) {
  tree_.decide(info.decisions);
}

template <int D>
Status Recorder<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  const Status status = tree_.insert(object, box, mobility);
  if (!counts(status)) return status;
  requests_.add_insert(object, box, mobility);
  know(object, true);
  return status;
}

template <int D>
Status Recorder<D>::insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  if (volume.kind != volume_kind()) return insert(object, box_of(volume), mobility);
  const Status status = tree_.insert(object, volume, mobility);
  if (!counts(status)) return status;
  requests_.add_insert(object, volume, mobility);
  know(object, true);
  return status;
}

template <int D>
Status Recorder<D>::move(ObjectId object, const Box<D>& box) {
  const Status status = tree_.move(object, box);
  if (counts(status)) requests_.add_move(object, box);
  return status;
}

template <int D>
Status Recorder<D>::move(ObjectId object, const Volume<D>& volume) {
  if (volume.kind != volume_kind()) return move(object, box_of(volume));
  const Status status = tree_.move(object, volume);
  if (counts(status)) requests_.add_move(object, volume);
  return status;
}

template <int D>
void Recorder<D>::know(ObjectId object, bool present) {
  if (known_.size() <= object.index()) known_.resize(object.index() + 1);
  known_[object.index()] = present;
}

template <int D>
Status Recorder<D>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  const Status status = tree_.move_many(objects, boxes);
  if (status == Status::ok) {
    requests_.add_moves(objects, boxes);
    return status;
  }
  std::vector<ObjectId> known;
  std::vector<Box<D>> their_boxes;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!knows(objects[k])) continue;
    known.push_back(objects[k]);
    their_boxes.push_back(boxes[k]);
  }
  requests_.add_moves(known, their_boxes);
  return status;
}

template <int D>
Status Recorder<D>::remove(ObjectId object) {
  const Status status = tree_.remove(object);
  if (!counts(status)) return status;
  requests_.add_remove(object);
  know(object, false);
  if (object.index() < shapes_.size()) shapes_[object.index()] = kNoShape;
  return status;
}

template <int D>
void Recorder<D>::step() {
  if (!info_.changes.empty()) tree_.set_config(config_of(info_, tree_.steps() + 1));
  tree_.step();
  const auto start = std::chrono::steady_clock::now();
  record();
  count_seconds(start);
}

template <int D>
void Recorder<D>::finish() {
  const auto start = std::chrono::steady_clock::now();
  writer_.finish();
  count_seconds(start);
}

template <int D>
void Recorder<D>::count_seconds(std::chrono::steady_clock::time_point since) {
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

/// The log may hold events of earlier steps that were not taken.
template <int D>
std::span<const Event> Recorder<D>::events_of_step() const {
  const std::vector<Event>& all = tree_.trace().events();
  const auto first = std::ranges::lower_bound(all, next_event_, {}, &Event::id);
  return {first, all.end()};
}

/// Whether nothing was requested and nothing happened: then tree and pairs are unchanged. Fat boxes change
/// without a request, and other parameters may change anything.
template <int D>
bool Recorder<D>::rested(std::span<const Event> events) const {
  return tree_.steps() > 1 && info_.changes.empty() && !tree_.config().byte_sweep &&
         requests_.objects.empty() && std::ranges::all_of(events, begins_phase);
}

/// Most objects keep their shapes, some change their size all the time.
template <int D>
Look<D> Recorder<D>::look_of(ObjectId object, const Appearance<D>& appearance) {
  if (appearance.shape == nullptr) return {};
  if (shapes_.size() <= object.index()) shapes_.resize(object.index() + 1, kNoShape);
  std::uint32_t& number = shapes_[object.index()];
  ShapeNumbers<D>& shapes = writer_.shapes();
  if (number != kNoShape && shapes[number] != *appearance.shape) {
    const auto stretch =
        appearance.stretch ? std::nullopt : stretch_between<D>(shapes[number], *appearance.shape);
    if (stretch) return {number, appearance.turn, *stretch};
    number = kNoShape;
  }
  if (number == kNoShape) number = shapes.number_of(*appearance.shape);
  return {number, appearance.turn, appearance.stretch.value_or(Stretch<D>{})};
}

template <int D>
std::span<const Look<D>> Recorder<D>::find_looks() {
  looks_.clear();
  if (!appearance_) return looks_;
  looks_.reserve(requests_.objects.size());
  for (const ObjectId object : requests_.objects) {
    if (!knows(object)) {
      looks_.emplace_back();
      continue;
    }
    looks_.push_back(look_of(object, appearance_(object)));
  }
  return looks_;
}

template <int D>
void Recorder<D>::record() {
  const std::span<const Event> events = events_of_step();
  StepRow row;
  row.step = tree_.steps();
  row.statistics = tree_.statistics();
  row.pairs = tree_.pairs().size();
  row.first_event = next_event_;
  row.events = events.size();
  if (!rested(events)) {
    state_hash_ = tree_.state_hash();
    pairs_hash_ = hash_pairs(tree_.pairs());
  }
  row.state_hash = state_hash_;
  row.pairs_hash = pairs_hash_;
  writer_.add(requests_, events, row, find_looks());
  if (writer_.wants_keyframe()) writer_.add(tree_.state());
  next_event_ += events.size();
  requests_.clear();
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace kerf

#include "core/recording/recorder.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/base/float_mode.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

/// The volume that a table of boxes or other volumes stores for one of the wrong kind: a box, or a volume
/// that cannot be placed.
template <int D>
Box<D> box_of(const Volume<D>& volume) {
  const DefaultFloats floats;
  return is_ordered(volume) ? volume.box : Box<D>::empty();
}

/// `info`, if it is that of a run that this tree can begin.
template <int D>
const RecordingInfo& checked(Bsp<D, EventLog>& tree, const RecordingInfo& info) {
  const auto expect = [](bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("a tree cannot be recorded " + what);
  };
  expect(info.dimension == D, "as one in " + std::to_string(info.dimension) + "D: it has another dimension");
  expect(info.volume == tree.volume_kind(), "as one of other volumes than it has");
  expect(info.config == tree.config(), "with another configuration than it has");
  expect(tree.steps() == 0 && tree.objects().bound() == 0,
         "that has had a step or an object: make a new one");
  tree.decide(info.decisions);
  return info;
}

}  // namespace

/// The scope of what changes the run or its recording. If it ends by an exception, the two may differ, or
/// part of a step may be written: nothing more is.
template <int D>
class Recorder<D>::Change {
 public:
  explicit Change(Recorder& recorder) : recorder_(recorder) {
    recorder.check_open();
    recorder.has_ended_ = true;
  }
  void finish() { recorder_.has_ended_ = false; }

 private:
  DefaultFloats floats_;
  Recorder& recorder_;
};

template <int D>
Recorder<D>::Recorder(Bsp<D, EventLog>& tree, const std::filesystem::path& path, const RecordingInfo& info)
    : tree_(tree), info_(checked(tree, info)), writer_(path, info) {}

template <int D>
void Recorder<D>::check_open() const {
  if (!has_ended_) return;
  throw std::runtime_error("the recording ended with step " + info_.names.step(writer_.committed()) +
                           ": it is complete, or an earlier call failed; make a new tree and a new recorder");
}

template <int D>
void Recorder<D>::check_alone() const {
  if (tree_.steps() != steps_)
    throw std::invalid_argument("the tree took a step without its recorder: ask the recorder for all steps");
  if (tree_.config() != config_of(info_, steps_))
    throw std::invalid_argument("the tree has another configuration than its recording says");
}

/// A request that the tree takes is written down.
template <int D>
template <class Ask, class Write>
Status Recorder<D>::request(Ask ask, Write write) {
  Change change(*this);
  const Status status = ask();
  if (!is_refused(status)) write();
  change.finish();
  return status;
}

template <int D>
Status Recorder<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  return request([&] { return tree_.insert(object, box, mobility); },
                 [&] {
                   requests_.add_insert(object, box, mobility);
                   know(object, true);
                 });
}

template <int D>
Status Recorder<D>::insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  if (volume.kind != volume_kind()) return insert(object, box_of(volume), mobility);
  return request([&] { return tree_.insert(object, volume, mobility); },
                 [&] {
                   requests_.add_insert(object, volume, mobility);
                   know(object, true);
                 });
}

template <int D>
Status Recorder<D>::move(ObjectId object, const Box<D>& box) {
  return request([&] { return tree_.move(object, box); }, [&] { requests_.add_move(object, box); });
}

template <int D>
Status Recorder<D>::move(ObjectId object, const Volume<D>& volume) {
  if (volume.kind != volume_kind()) return move(object, box_of(volume));
  return request([&] { return tree_.move(object, volume); }, [&] { requests_.add_move(object, volume); });
}

template <int D>
void Recorder<D>::know(ObjectId object, bool present) {
  if (known_.size() <= object.index()) known_.resize(object.index() + 1);
  known_[object.index()] = present;
}

template <int D>
Status Recorder<D>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  check_open();
  if (objects.size() != boxes.size()) return tree_.move_many(objects, boxes);  // throws, and changes nothing
  Change change(*this);
  const Status status = tree_.move_many(objects, boxes);
  if (status == Status::ok) {
    requests_.add_moves(objects, boxes);
  } else {
    add_moves_of_known(objects, boxes);
  }
  change.finish();
  return status;
}

/// Of the others the moves were refused.
template <int D>
void Recorder<D>::add_moves_of_known(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  std::vector<ObjectId> known;
  std::vector<Box<D>> their_boxes;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!knows(objects[k])) continue;
    known.push_back(objects[k]);
    their_boxes.push_back(boxes[k]);
  }
  requests_.add_moves(known, their_boxes);
}

template <int D>
Status Recorder<D>::remove(ObjectId object) {
  return request([&] { return tree_.remove(object); },
                 [&] {
                   requests_.add_remove(object);
                   know(object, false);
                   if (object.index() < shapes_.size()) shapes_[object.index()] = kNoShape;
                 });
}

template <int D>
void Recorder<D>::step() {
  check_open();
  check_alone();
  Change change(*this);
  if (!info_.changes.empty()) tree_.set_config(config_of(info_, tree_.steps() + 1));
  tree_.step();
  const auto start = std::chrono::steady_clock::now();
  record();
  count_seconds(start);
  change.finish();
}

template <int D>
void Recorder<D>::add_theirs(const TheirChanges<D>& changes) {
  Change change(*this);
  writer_.add(changes);
  change.finish();
}

template <int D>
void Recorder<D>::add_theirs(std::span<const Pair> pairs, std::span<const JudgedPair> judged) {
  Change change(*this);
  writer_.add(pairs, judged);
  change.finish();
}

template <int D>
void Recorder<D>::add_theirs(const TheirStructure<D>& structure) {
  Change change(*this);
  writer_.add(structure);
  change.finish();
}

template <int D>
void Recorder<D>::finish() {
  const Change last(*this);
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
  ++steps_;
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace kerf

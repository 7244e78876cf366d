#include "frames/advise/recorded_motion.h"

#include <algorithm>
#include <utility>

#include "core/recording/step_requests.h"

namespace kerf {
namespace {

/// Makes the requests of a step and calls `touch` for the object of each.
template <int D, class Touch>
void play_step(RecordingReader<D>& recording, std::uint32_t step, ObjectTable<D>& table, Touch touch) {
  for_each_request(recording.step(step).requests, recording.info().volume,
                   [&](const ObjectRequest<D>& request) {
                     apply(request, table);
                     touch(request.object);
                   });
}

/// The median of the mean extents; 1 without objects, or if most are points.
template <int D>
Scalar usual_size(const ObjectTable<D>& table) {
  std::vector<Scalar> sizes;
  for_each_placed(table, [&](ObjectId object) {
    const Vector<D> extent = table.box(object).extent();
    Scalar sum = 0;
    for (int i = 0; i < D; ++i) sum += extent[i];
    sizes.push_back(sum / D);
  });
  if (sizes.empty()) return 1;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return *middle > 0 ? *middle : 1;
}

}  // namespace

template <int D>
class RecordedRun<D>::Replay final : public Motion<D> {
 public:
  explicit Replay(const RecordedRun& run) : Motion<D>(0), run_(run) {
    this->boxes_.assign(run.objects(), no_box<D>());
    this->moving_ = run.moving_;
    this->bounds_ = run.bounds_;
    this->box_size_ = run.box_size_;
    this->all_move_ = false;
    this->most_changes_ = 2 * run.objects();
    while (step_ < run.steps_.first) play();
    for (std::uint32_t id = 0; id < table_.bound(); ++id) settle({id});
    forget();
  }
  void advance() override {
    forget();
    play();
    for (const ObjectId object : touched_) settle(object);
  }

 private:
  void forget() {
    this->moved_.clear();
    this->inserted_.clear();
    this->removed_.clear();
  }
  void play() {
    ++step_;
    touched_.clear();
    play_step(*run_.recording_, step_, table_, [this](ObjectId object) {
      if (object.index() >= touched_in_.size()) touched_in_.resize(object.index() + 1);
      if (std::exchange(touched_in_[object.index()], step_) != step_) touched_.push_back(object);
    });
  }
  /// Brings the motion's object up to date with the recorded one.
  void settle(ObjectId object) {
    if (object.index() >= numbers_.size()) numbers_.resize(object.index() + 1, kNone);
    const std::uint32_t now = run_.number(table_, object);
    const std::uint32_t before = std::exchange(numbers_[object.index()], now);
    if (before != now && before != kNone) {
      this->removed_.push_back({before});
      this->boxes_[before] = no_box<D>();
    }
    if (now == kNone) return;
    (before == now ? this->moved_ : this->inserted_).push_back({now});
    this->boxes_[now] = table_.box(object);
  }

  const RecordedRun& run_;
  ObjectTable<D> table_;
  std::uint32_t step_ = 0;
  std::vector<ObjectId> touched_;
  std::vector<std::uint32_t> touched_in_;  ///< by recorded id, the last step
  std::vector<std::uint32_t> numbers_;     ///< by recorded id
};

template <int D>
RecordedRun<D>::RecordedRun(std::shared_ptr<RecordingReader<D>> recording, const StepRange& steps,
                            const Watch& watch)
    : recording_(std::move(recording)), steps_(steps) {
  ObjectTable<D> table;
  for (std::uint32_t step = 1; step <= steps_.last; ++step) {
    watch(step);
    play_step(*recording_, step, table, [&](ObjectId object) {
      if (step > steps_.first) mark(table, object);
    });
    for (std::uint32_t id = 0; step == steps_.first && id < table.bound(); ++id) mark(table, {id});
    if (step >= steps_.first) most_at_once_ = std::max(most_at_once_, table.size());
  }
  box_size_ = usual_size(table);
  number_all();
}

template <int D>
std::unique_ptr<Motion<D>> RecordedRun<D>::motion() const {
  return std::make_unique<Replay>(*this);
}

template <int D>
std::uint32_t RecordedRun<D>::number(const ObjectTable<D>& table, ObjectId object) const {
  return table.is_placed(object) ? numbers_[table.is_fixed(object) ? 1 : 0][object.index()] : kNone;
}

template <int D>
void RecordedRun<D>::mark(const ObjectTable<D>& table, ObjectId object) {
  if (!table.is_placed(object)) return;
  auto& marks = numbers_[table.is_fixed(object) ? 1 : 0];
  if (object.index() >= marks.size()) marks.resize(table.bound(), kNone);
  marks[object.index()] = 0;
  bounds_ = join(bounds_, table.box(object));
}

template <int D>
void RecordedRun<D>::number_all() {
  std::uint32_t next = 0;
  for (auto& marks : numbers_) {
    for (std::uint32_t& mark : marks)
      if (mark != kNone) mark = next++;
    if (&marks == &numbers_.front()) moving_ = next;
  }
  fixed_ = next - moving_;
}

template class RecordedRun<2>;
template class RecordedRun<3>;

}  // namespace kerf

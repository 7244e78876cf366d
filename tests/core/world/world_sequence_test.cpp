// Long random sequences of all requests, held against a world of maps and loops.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "core/base/random.h"
#include "core/world/world.h"
#include "tests/core/world/model_world.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr double kSide = 20;

/// Pairs that the callback of some sequences refuses.
bool is_welcome(const ObjectDef& a, const ObjectDef& b) { return (a.user_data ^ b.user_data) % 5 != 0; }

template <int D>
std::vector<WorldPair> list(const typename ModelWorld<D>::Report& report) {
  std::vector<WorldPair> pairs;
  for (const auto& [key, pair] : report) pairs.push_back(pair);
  return pairs;
}

std::vector<WorldPair> list(std::span<const WorldPair> pairs) { return {pairs.begin(), pairs.end()}; }

template <int D>
class Sequence {
 public:
  Sequence(std::uint64_t seed, const WorldOptions& options, bool asks)
      : random_(seed), asks_(asks), model_(options.pairs_of), world_(options), tag_(options.tag) {
    if (asks_) listen(world_);
  }

  void run(int requests) {
    for (int k = 0; k < requests && !testing::Test::HasFailure(); ++k) request();
    EXPECT_LE(world_.bound(), most_ * 2 + 20) << "memory follows what lived at a time";
  }

 private:
  void listen(World<D>& world) {
    world.set_callback([this](const WorldPair& pair) {
      const ObjectDef* const a = world_.find(pair.a);
      const ObjectDef* const b = world_.find(pair.b);
      EXPECT_TRUE(a != nullptr && b != nullptr);
      return a != nullptr && b != nullptr && is_welcome(*a, *b);
    });
  }

  void request() {
    switch (random_.below(17)) {
      case 0:
      case 1:
        return insert();
      case 2:
        return insert_many();
      case 3:
        return remove();
      case 4:
        return remove_many();
      case 5:
        return set_kind();
      case 6:
        return set_filter();
      case 7:
        return set_user_data();
      case 8:
        return set_margin();
      case 9:
        return save_and_restore();
      case 10:
      case 11:
        return step();
      case 12:
        return shift_origin();
      default:
        return move_many();
    }
  }

  Box<D> some_box() {
    const Box<D> box = random_box<D>(random_, kSide, random_.below(20) == 0 ? kSide / 2 : 1);
    return {box.min + origin_, box.max + origin_};
  }
  /// Now and then a box that is none.
  Box<D> given_box() {
    Box<D> box = some_box();
    if (random_.below(30) == 0) box.max[D - 1] = std::numeric_limits<Scalar>::quiet_NaN();
    if (random_.below(30) == 0) std::swap(box.min[0], box.max[0]);
    return box;
  }
  static WorldStatus judge(const Box<D>& box) {
    return is_valid(box) ? WorldStatus::ok : WorldStatus::bad_box;
  }

  ObjectDef some_def() {
    ObjectDef def;
    def.kind = static_cast<ObjectKind>(random_.below(kObjectKinds));
    def.margin = random_.below(3) == 0 ? static_cast<Scalar>(random_.uniform(0, 1)) : 0;
    def.filter = some_filter();
    def.user_data = random_.below(10);
    return def;
  }
  PairFilter some_filter() {
    if (random_.below(2) == 0) return {};
    return {random_.below(8), random_.below(8), static_cast<std::int32_t>(random_.below(5)) - 2};
  }

  /// Mostly one that lives; else one that lived, or never did.
  Handle some_handle() {
    if (random_.below(12) == 0)
      return make_handle(random_.below(60), random_.below(4),
                         static_cast<std::uint8_t>(random_.below(2) + tag_));
    const std::vector<Handle>& from = random_.below(10) == 0 || alive_.empty() ? ever_ : alive_;
    return from.empty() ? Handle{} : from[random_.below(static_cast<std::uint32_t>(from.size()))];
  }
  [[nodiscard]] bool lives(Handle handle) const { return model_.objects.contains(handle); }

  void born(Handle handle, const Box<D>& box, const ObjectDef& def) {
    EXPECT_TRUE(given_.insert(handle).second) << "a handle was given twice";
    model_.insert(handle, box, def);
    alive_.push_back(handle);
    ever_.push_back(handle);
    most_ = std::max(most_, alive_.size());
  }
  void died(Handle handle) {
    model_.objects.erase(handle);
    std::erase(alive_, handle);
  }

  void insert() {
    const Box<D> box = given_box();
    const ObjectDef def = some_def();
    const auto [status, handle] = world_.insert(box, def);
    EXPECT_EQ(status, judge(box));
    EXPECT_EQ(handle.is_none(), is_failure(status));
    if (!handle.is_none()) born(handle, box, def);
  }

  void insert_many() {
    if (alive_.size() > 60) return;
    const std::size_t count = random_.below(12);
    std::vector<Box<D>> boxes(count);
    std::vector<ObjectDef> defs(count);
    std::ranges::generate(boxes, [&] { return given_box(); });
    std::ranges::generate(defs, [&] { return some_def(); });
    std::vector<Handle> handles(count);
    std::vector<WorldStatus> statuses(count);
    const WorldStatus sum = world_.insert(boxes, defs, handles, statuses);
    const auto bad = std::ranges::find_if(statuses, is_failure);
    EXPECT_EQ(sum, bad == statuses.end() ? WorldStatus::ok : *bad);
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_EQ(statuses[k], judge(boxes[k]));
      if (!is_failure(statuses[k])) born(handles[k], boxes[k], defs[k]);
    }
  }

  void move_many() {
    const std::size_t count = random_.below(40);
    std::vector<Handle> handles(count);
    std::vector<Box<D>> boxes(count);
    const bool clean = random_.below(2) == 0 && !alive_.empty();
    for (std::size_t k = 0; k < count; ++k) {
      handles[k] = clean ? alive_[random_.below(static_cast<std::uint32_t>(alive_.size()))] : some_handle();
      boxes[k] = clean || !lives(handles[k]) ? some_box() : given_box();
      if (lives(handles[k]) && random_.below(4) != 0) boxes[k] = nudged(model_.objects.at(handles[k]).box);
    }
    std::vector<WorldStatus> statuses(random_.below(2) == 0 ? count : 0);
    (void)world_.move(handles, boxes, statuses);
    for (std::size_t k = 0; k < count; ++k) {
      const WorldStatus expected = lives(handles[k]) ? judge(boxes[k]) : WorldStatus::stale_handle;
      if (!statuses.empty()) {
        EXPECT_EQ(statuses[k], expected);
      }
      if (expected == WorldStatus::ok) model_.move(handles[k], boxes[k]);
    }
  }
  Box<D> nudged(Box<D> box) {
    const Vector<D> by = random_point<D>(random_, -0.1, 0.1);
    return {box.min + by, box.max + by};
  }

  void remove() {
    const Handle handle = some_handle();
    EXPECT_EQ(world_.remove(handle), lives(handle) ? WorldStatus::ok : WorldStatus::stale_handle);
    died(handle);
  }
  void remove_many() {
    std::vector<Handle> handles(random_.below(8));
    std::ranges::generate(handles, [&] { return some_handle(); });
    std::vector<WorldStatus> statuses(handles.size());
    (void)world_.remove(handles, statuses);
    for (std::size_t k = 0; k < handles.size(); ++k) {
      EXPECT_EQ(statuses[k], lives(handles[k]) ? WorldStatus::ok : WorldStatus::stale_handle);
      died(handles[k]);
    }
  }

  void set_kind() {
    const Handle handle = some_handle();
    const auto kind = static_cast<ObjectKind>(random_.below(kObjectKinds));
    if (expect_alive(world_.set_kind(handle, kind), handle)) model_.objects.at(handle).def.kind = kind;
  }
  void set_filter() {
    const Handle handle = some_handle();
    const PairFilter filter = some_filter();
    if (expect_alive(world_.set_filter(handle, filter), handle))
      model_.objects.at(handle).def.filter = filter;
  }
  void set_user_data() {
    const Handle handle = some_handle();
    const std::uint64_t data = random_.below(10);
    if (expect_alive(world_.set_user_data(handle, data), handle))
      model_.objects.at(handle).def.user_data = data;
  }
  void set_margin() {
    const Handle handle = some_handle();
    const Scalar margin = random_.below(2) == 0 ? 0 : static_cast<Scalar>(random_.uniform(0, 1));
    if (expect_alive(world_.set_margin(handle, margin), handle)) model_.set_margin(handle, margin);
  }
  void shift_origin() {
    const Vector<D> by = random_point<D>(random_, -kSide, kSide);
    EXPECT_EQ(world_.shift_origin(by), WorldStatus::ok);
    model_.shift_origin(by);
    origin_ = origin_ + by;
  }
  bool expect_alive(WorldStatus status, Handle handle) {
    EXPECT_EQ(status, lives(handle) ? WorldStatus::ok : WorldStatus::stale_handle);
    return lives(handle);
  }

  /// Another world goes on.
  void save_and_restore() {
    std::vector<std::uint8_t> bytes;
    if (world_.save(bytes) == WorldStatus::unstepped) return;
    World<D> other;
    std::string why;
    ASSERT_EQ(other.restore(bytes, &why), WorldStatus::ok) << why;
    EXPECT_EQ(list(other.begun()), list(world_.begun()));
    EXPECT_EQ(list(other.ended()), list(world_.ended()));
    world_ = std::move(other);
    world_.set_threads(1 + random_.below(2), Sharing::always);
    if (asks_) listen(world_);
    compare();
  }

  void step() {
    if (random_.below(40) == 0) {  // all go
      (void)world_.remove(std::vector(alive_));
      while (!alive_.empty()) died(alive_.back());
    }
    world_.step();
    model_.step([this](const ObjectDef& a, const ObjectDef& b) { return !asks_ || is_welcome(a, b); });
    using Model = ModelWorld<D>;
    EXPECT_EQ(list(world_.begun()), Model::difference(model_.now, model_.before));
    EXPECT_EQ(list(world_.ended()), Model::difference(model_.before, model_.now));
    compare();
  }

  void compare() {
    ASSERT_EQ(list(world_.pairs()), list<D>(model_.now));
    ASSERT_EQ(world_.size(), model_.objects.size());
    std::size_t seen = 0;
    world_.for_each([&](Handle handle) {
      ++seen;
      ASSERT_TRUE(lives(handle));
      const auto& object = model_.objects.at(handle);
      EXPECT_EQ(world_.box(handle), object.box);
      EXPECT_EQ(world_.fat_box(handle), object.fat);
      EXPECT_EQ(*world_.find(handle), object.def);
      EXPECT_LT(handle.index(), world_.bound());
    });
    EXPECT_EQ(seen, world_.size());
  }

  Random random_;
  Vector<D> origin_{};  ///< of the boxes that come
  bool asks_;
  ModelWorld<D> model_;
  World<D> world_;
  std::uint8_t tag_;
  std::vector<Handle> alive_;
  std::vector<Handle> ever_;
  std::set<Handle> given_;
  std::size_t most_ = 0;
};

template <class T>
class WorldSequence : public testing::Test {};
TYPED_TEST_SUITE(WorldSequence, Dimensions, DimensionNames);

TYPED_TEST(WorldSequence, IsThatOfMapsAndLoops) {
  for (std::uint64_t seed = 0; seed < 24 && !this->HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WorldOptions options;
    options.tag = static_cast<std::uint8_t>(seed % 3);
    options.pairs_of = seed % 2 == 0 ? PairsOf::fat_boxes : PairsOf::exact_boxes;
    if (seed % 4 < 2) kerf::apply(options.config, "min_threshold=3,max_threshold=6,schedule_interval=2");
    Sequence<TypeParam::value>(seed, options, seed % 5 == 0).run(1500);
  }
}

}  // namespace
}  // namespace kerf::test

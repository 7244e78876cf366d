#include "core/world/world.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();

template <class T>
class WorldOf : public testing::Test {
 public:
  static constexpr int kD = T::value;
  using Boxes = std::vector<Box<kD>>;

  static Box<kD> at(Scalar x, Scalar half = 1) {
    Vector<kD> center{};
    center[0] = x;
    return box_at<kD>(center, half);
  }
  Handle add(Scalar x, const ObjectDef& def = {}) {
    const auto [status, handle] = world.insert(at(x), def);
    EXPECT_EQ(status, WorldStatus::ok);
    return handle;
  }
  /// The reported pairs as texts of indices: "0-1 0-2*", * for sensors.
  static std::string text(std::span<const WorldPair> pairs) {
    std::string all;
    for (const WorldPair& pair : pairs)
      all += (all.empty() ? "" : " ") + std::to_string(pair.a.index()) + "-" +
             std::to_string(pair.b.index()) + (pair.is_sensor() ? "*" : "");
    return all;
  }

  World<kD> world;
};
TYPED_TEST_SUITE(WorldOf, Dimensions, DimensionNames);

ObjectDef of_kind(ObjectKind kind) {
  ObjectDef def;
  def.kind = kind;
  return def;
}

ObjectDef with_filter(std::uint64_t category, std::uint64_t mask, std::int32_t group = 0) {
  ObjectDef def;
  def.filter = {category, mask, group};
  return def;
}

TYPED_TEST(WorldOf, ReportsPairsThatBeginLastAndEnd) {
  const Handle a = this->add(0);
  const Handle b = this->add(1);
  EXPECT_TRUE(this->world.pairs().empty()) << "requests take effect in a step";
  this->world.step();
  ASSERT_EQ(this->text(this->world.begun()), "0-1");
  EXPECT_EQ(this->world.begun()[0].a, a);
  EXPECT_EQ(this->world.begun()[0].b, b);
  this->world.step();
  EXPECT_EQ(this->text(this->world.begun()) + "|" + this->text(this->world.pairs()), "|0-1");
  EXPECT_EQ(this->world.move(b, this->at(9)), WorldStatus::ok);
  this->world.step();
  EXPECT_EQ(this->text(this->world.ended()) + "|" + this->text(this->world.pairs()), "0-1|");
}

TYPED_TEST(WorldOf, KindsDecideWhichPairsAreReported) {
  for (const ObjectKind kind :
       {ObjectKind::fixed, ObjectKind::kinematic, ObjectKind::moving, ObjectKind::sensor, ObjectKind::sensor})
    this->add(0, of_kind(kind));
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "0-2 0-3* 0-4* 1-2 1-3* 1-4* 2-3* 2-4* 3-4*");
}

TYPED_TEST(WorldOf, AKindThatChangesBeginsAndEndsPairs) {
  const Handle a = this->add(0, of_kind(ObjectKind::fixed));
  const Handle b = this->add(0, of_kind(ObjectKind::fixed));
  const auto change = [&](Handle object, ObjectKind kind) {
    EXPECT_EQ(this->world.set_kind(object, kind), WorldStatus::ok);
    EXPECT_EQ(this->world.find(object)->kind, kind);
    this->world.step();
    return this->text(this->world.begun()) + "|" + this->text(this->world.ended());
  };
  EXPECT_EQ(change(a, ObjectKind::kinematic), "|");
  EXPECT_EQ(change(a, ObjectKind::moving), "0-1|");
  EXPECT_EQ(change(b, ObjectKind::moving), "|");
  EXPECT_EQ(change(b, ObjectKind::sensor), "0-1*|0-1") << "a pair that becomes a sensor's ends and begins";
  EXPECT_EQ(change(a, ObjectKind::fixed), "|");
  EXPECT_EQ(change(b, ObjectKind::fixed), "|0-1*");
}

TYPED_TEST(WorldOf, FiltersFollowBox2D) {
  this->add(0, with_filter(1, 2));
  this->add(0, with_filter(2, 1));
  this->add(0, with_filter(2, 4));
  this->add(0, with_filter(1, 2, 7));
  this->add(0, with_filter(1, 2, 7));
  this->add(0, with_filter(1, 2, -7));
  this->add(0, with_filter(2, 1, -7));
  this->add(0, with_filter(2, 1, 7));
  this->world.step();
  // 0, 3, 4 and 5 see 1, 6 and 7; group 7 is 3, 4, 7; group -7 is 5, 6.
  EXPECT_EQ(this->text(this->world.pairs()), "0-1 0-6 0-7 1-3 1-4 1-5 3-4 3-6 3-7 4-6 4-7 5-7");
}

TYPED_TEST(WorldOf, AFilterThatChangesBeginsAndEndsPairs) {
  const Handle a = this->add(0);
  this->add(0);
  this->world.step();
  EXPECT_EQ(this->world.set_filter(a, {1, 0, 0}), WorldStatus::ok);
  EXPECT_EQ(this->text(this->world.pairs()), "0-1") << "until the next step";
  this->world.step();
  EXPECT_EQ(this->text(this->world.ended()), "0-1");
  EXPECT_EQ(this->world.set_filter(a, {}), WorldStatus::ok);
  this->world.step();
  EXPECT_EQ(this->text(this->world.begun()), "0-1");
}

TYPED_TEST(WorldOf, AShiftOfTheOriginTakesFatBoxesAlong) {
  ObjectDef fat;
  fat.margin = 2;
  const Handle a = this->add(0, fat);                            // -1 to 1, fat -3 to 3
  this->add(4.125F);                                             // from 3.125 on
  EXPECT_EQ(this->world.move(a, this->at(1)), WorldStatus::ok);  // within the fat box, which stays
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "");
  Vector<TestFixture::kD> by{};
  by[0] = -0.25F;
  EXPECT_EQ(this->world.shift_origin(by), WorldStatus::ok);
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "") << "nothing moved but the origin";
  EXPECT_EQ(this->world.fat_box(a)->max[0], 2.75F);
  EXPECT_EQ(this->world.box(a)->max[0], 1.75F);
  by[0] = std::numeric_limits<Scalar>::max();
  EXPECT_EQ(this->world.shift_origin(by), WorldStatus::ok) << "rounded, not out of range";
  EXPECT_EQ(this->world.shift_origin(by), WorldStatus::clamped);
  EXPECT_TRUE(contains(*this->world.fat_box(a), *this->world.box(a)));
}

TYPED_TEST(WorldOf, TheCallbackDecidesAboutWhatFiltersAllow) {
  for (int k = 0; k < 3; ++k) this->add(0);
  const Handle filtered = this->add(0, with_filter(1, 0));
  EXPECT_EQ(this->world.set_user_data(filtered, 5), WorldStatus::ok);
  std::vector<WorldPair> asked;
  this->world.set_callback([&](const WorldPair& pair) {
    asked.push_back(pair);
    return this->world.find(pair.a)->user_data == this->world.find(pair.b)->user_data;
  });
  const Handle last = make_handle(2, 1, 0);
  EXPECT_EQ(this->world.set_user_data(last, 5), WorldStatus::ok);
  this->world.step();
  EXPECT_EQ(this->text(asked), "0-1 0-2 1-2");
  EXPECT_EQ(this->text(this->world.pairs()), "0-1");
  EXPECT_EQ(this->world.set_user_data(last, 0), WorldStatus::ok);
  this->world.step();
  EXPECT_EQ(this->text(this->world.begun()), "0-2 1-2");
  this->world.set_callback({});
  asked.clear();
  this->world.step();
  EXPECT_TRUE(asked.empty());
}

TYPED_TEST(WorldOf, ACallbackThatThrowsLeavesTheReports) {
  const Handle a = this->add(0);
  this->add(0);
  this->world.step();
  this->add(0);
  EXPECT_EQ(this->world.remove(a), WorldStatus::ok);
  this->world.set_callback([](const WorldPair&) -> bool { throw std::runtime_error("no"); });
  EXPECT_THROW(this->world.step(), std::runtime_error);
  EXPECT_EQ(this->text(this->world.pairs()) + "|" + this->text(this->world.begun()), "0-1|0-1");
  this->world.set_callback({});
  this->world.step();
  EXPECT_EQ(this->text(this->world.begun()) + "|" + this->text(this->world.ended()), "1-2|0-1");
}

TYPED_TEST(WorldOf, ARemovedObjectsPairsEndWithItsHandle) {
  const Handle a = this->add(0);
  this->add(0);
  this->world.step();
  EXPECT_EQ(this->world.remove(a), WorldStatus::ok);
  const Handle next = this->add(0);
  EXPECT_FALSE(this->world.contains(a));
  EXPECT_EQ(this->world.find(a), nullptr);
  EXPECT_FALSE(this->world.box(a).has_value());
  this->world.step();
  ASSERT_EQ(this->world.ended().size(), 1U);
  EXPECT_EQ(this->world.ended()[0].a, a);
  EXPECT_EQ(this->world.begun().size(), 1U);
  EXPECT_EQ(this->world.begun()[0].b, next);
}

TYPED_TEST(WorldOf, RequestsThatFailChangeNothing) {
  const Handle a = this->add(0);
  this->world.step();
  std::vector<std::uint8_t> before;
  ASSERT_EQ(this->world.save(before), WorldStatus::ok);
  Box<TypeParam::value> bad = this->at(0);
  bad.max[1] = kNan;
  EXPECT_EQ(this->world.move(a, bad), WorldStatus::bad_box);
  EXPECT_EQ(this->world.insert(bad).status, WorldStatus::bad_box);
  EXPECT_TRUE(this->world.insert(bad).handle.is_none());
  std::swap(bad.min[0], bad.max[0]);
  bad.max[1] = 1;
  EXPECT_EQ(this->world.move(a, bad), WorldStatus::bad_box) << "an inverted box";
  for (const Handle stranger : {Handle{}, Handle{UINT64_MAX}, Handle{~a.value}, make_handle(0, 2, 0),
                                make_handle(1, 1, 0), make_handle(0, 1, 1)}) {
    EXPECT_EQ(this->world.move(stranger, this->at(1)), WorldStatus::stale_handle);
    EXPECT_EQ(this->world.remove(stranger), WorldStatus::stale_handle);
    EXPECT_EQ(this->world.set_kind(stranger, ObjectKind::fixed), WorldStatus::stale_handle);
    EXPECT_EQ(this->world.set_filter(stranger, {}), WorldStatus::stale_handle);
    EXPECT_EQ(this->world.set_user_data(stranger, 1), WorldStatus::stale_handle);
    EXPECT_EQ(this->world.set_margin(stranger, 1), WorldStatus::stale_handle);
  }
  EXPECT_EQ(this->world.set_kind(a, static_cast<ObjectKind>(4)), WorldStatus::bad_value);
  for (const Scalar margin : {kNan, kInfinity, Scalar{-1}}) {
    EXPECT_EQ(this->world.set_margin(a, margin), WorldStatus::bad_value);
    ObjectDef def;
    def.margin = margin;
    EXPECT_EQ(this->world.insert(this->at(0), def).status, WorldStatus::bad_value);
  }
  std::vector<std::uint8_t> after;
  ASSERT_EQ(this->world.save(after), WorldStatus::ok);
  EXPECT_EQ(before, after);
}

TYPED_TEST(WorldOf, ABatchHasAStatusForEachObject) {
  Box<TypeParam::value> bad = this->at(0);
  bad.min[0] = kNan;
  Box<TypeParam::value> endless = this->at(0);
  endless.max[0] = kInfinity;
  const std::vector<Box<TypeParam::value>> boxes{this->at(0), bad, endless, this->at(5)};
  std::vector<Handle> handles(4);
  std::vector<WorldStatus> statuses(4);
  const std::array<ObjectDef, 1> one{};
  EXPECT_EQ(this->world.insert(boxes, one, handles, statuses), WorldStatus::bad_box);
  EXPECT_EQ(statuses,
            (std::vector{WorldStatus::ok, WorldStatus::bad_box, WorldStatus::clamped, WorldStatus::ok}));
  EXPECT_TRUE(handles[1].is_none());
  EXPECT_EQ(this->world.size(), 3U);
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "0-1 1-2");

  handles[1] = make_handle(9, 1, 0);
  const std::vector<Box<TypeParam::value>> moved{bad, this->at(0), endless, this->at(1)};
  EXPECT_EQ(this->world.move(handles, moved, statuses), WorldStatus::bad_box);
  EXPECT_EQ(statuses, (std::vector{WorldStatus::bad_box, WorldStatus::stale_handle, WorldStatus::clamped,
                                   WorldStatus::ok}));
  EXPECT_EQ(this->world.box(handles[0]), this->at(0)) << "it stays where it was";
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "0-1 0-2 1-2");

  handles[1] = handles[0];
  EXPECT_EQ(this->world.remove(handles, statuses), WorldStatus::stale_handle);
  EXPECT_EQ(statuses,
            (std::vector{WorldStatus::ok, WorldStatus::stale_handle, WorldStatus::ok, WorldStatus::ok}));
  EXPECT_EQ(this->world.size(), 0U);
}

TYPED_TEST(WorldOf, ABatchOfValidMovesSaysWhatWasClamped) {
  const std::vector<Handle> handles{this->add(0), this->add(5)};
  Box<TypeParam::value> endless = this->at(0);
  endless.max[0] = kInfinity;
  std::vector<WorldStatus> statuses(2, WorldStatus::full);
  EXPECT_EQ(this->world.move(handles, std::vector{this->at(0), endless}, statuses), WorldStatus::clamped);
  EXPECT_EQ(statuses, (std::vector{WorldStatus::ok, WorldStatus::clamped}));
  EXPECT_EQ(this->world.box(handles[1])->max[0], std::numeric_limits<Scalar>::max());
  EXPECT_EQ(this->world.move(handles, std::vector{this->at(0), this->at(0)}, statuses), WorldStatus::ok);
  EXPECT_EQ(statuses, (std::vector{WorldStatus::ok, WorldStatus::ok}));
}

TYPED_TEST(WorldOf, ListsOfDifferentLengthsFailAsAWhole) {
  const std::vector<Handle> handles{this->add(0), this->add(5)};
  std::vector<Handle> given(2);
  std::vector<WorldStatus> one(1);
  const std::vector<Box<TypeParam::value>> boxes{this->at(1), this->at(2)};
  const std::vector<Box<TypeParam::value>> single{this->at(1)};
  EXPECT_EQ(this->world.move(handles, single), WorldStatus::bad_length);
  EXPECT_EQ(this->world.move(handles, boxes, one), WorldStatus::bad_length);
  EXPECT_EQ(this->world.remove(handles, one), WorldStatus::bad_length);
  const std::vector<ObjectDef> three(3);
  const std::vector<ObjectDef> two(2);
  EXPECT_EQ(this->world.insert(boxes, three, given), WorldStatus::bad_length);
  EXPECT_EQ(this->world.insert(boxes, {}, given), WorldStatus::bad_length);
  EXPECT_EQ(this->world.insert(single, two, given), WorldStatus::bad_length);
  EXPECT_EQ(this->world.insert(boxes, two, given, one), WorldStatus::bad_length);
  EXPECT_EQ(this->world.size(), 2U);
  EXPECT_EQ(this->world.box(handles[0]), this->at(0));
}

TYPED_TEST(WorldOf, AMarginKeepsAFatBoxUntilTheBoxLeavesIt) {
  ObjectDef fat;
  fat.margin = 1;
  const Handle a = this->add(0, fat);
  EXPECT_EQ(this->world.fat_box(a), this->at(0, 2));
  EXPECT_EQ(this->world.move(a, this->at(0.5)), WorldStatus::ok);
  EXPECT_EQ(this->world.fat_box(a), this->at(0, 2));
  EXPECT_EQ(this->world.box(a), this->at(0.5));
  EXPECT_EQ(this->world.move(a, this->at(1.5)), WorldStatus::ok);
  EXPECT_EQ(this->world.fat_box(a), this->at(1.5, 2));
  EXPECT_EQ(this->world.set_margin(a, 0), WorldStatus::ok);
  EXPECT_EQ(this->world.fat_box(a), this->at(1.5));
  EXPECT_EQ(this->world.set_margin(a, 3), WorldStatus::ok);
  EXPECT_EQ(this->world.fat_box(a), this->at(1.5, 4));
  EXPECT_EQ(this->world.box(a), this->at(1.5));
}

TYPED_TEST(WorldOf, PairsAreOfFatBoxesOrOfExactOnes) {
  World<TypeParam::value> exact({.pairs_of = PairsOf::exact_boxes});
  ObjectDef fat;
  fat.margin = 1;
  for (World<TypeParam::value>* either : {&this->world, &exact}) {
    const Handle a = either->insert(this->at(0), fat).handle;
    (void)either->insert(this->at(2.5));
    either->step();
    EXPECT_EQ(this->text(either->pairs()), either == &exact ? "" : "0-1");
    EXPECT_EQ(either->move(a, this->at(0.5)), WorldStatus::ok);
    either->step();
    EXPECT_EQ(this->text(either->pairs()), "0-1");
  }
}

TYPED_TEST(WorldOf, AFatBoxStaysFinite) {
  ObjectDef fat;
  fat.margin = std::numeric_limits<Scalar>::max();
  const Handle a = this->add(1, fat);
  EXPECT_TRUE(is_valid(*this->world.fat_box(a)));
  this->add(1000);
  this->world.step();
  EXPECT_EQ(this->text(this->world.pairs()), "0-1");
}

TYPED_TEST(WorldOf, MemoryFollowsWhatLives) {
  for (int round = 0; round < 200; ++round) {
    std::vector<Handle> handles;
    for (int k = 0; k < 20; ++k) handles.push_back(this->add(static_cast<Scalar>(k)));
    if (round % 2 == 0) this->world.step();
    EXPECT_EQ(this->world.remove(handles), WorldStatus::ok);
    if (round % 3 == 0) this->world.step();
  }
  EXPECT_LE(this->world.bound(), 60U) << "200 times 20 objects lived";
}

TEST(World, OptionsThatCannotWorkAreRefused) {
  EXPECT_THROW(World<2>({.threads = 0}), std::invalid_argument);
  EXPECT_THROW(World<2>({.threads = 257}), std::invalid_argument);
  WorldOptions options;
  options.config.directions = 0;
  EXPECT_THROW(World<2>{options}, std::invalid_argument);
}

TEST(World, ANumberOfThreadsThatIsRefusedChangesNothing) {
  World<2> world({.threads = 2});
  for (const unsigned threads : {0U, 257U}) EXPECT_THROW(world.set_threads(threads), std::invalid_argument);
  (void)world.insert(box_at<2>({}, 1));
  (void)world.insert(box_at<2>({}, 1));
  world.step();
  EXPECT_EQ(world.pairs().size(), 1U);
}

TEST(World, EachStatusSaysSomethingElse) {
  std::vector<std::string> texts;
  for (int k = 0; k <= static_cast<int>(WorldStatus::busy); ++k)
    texts.emplace_back(to_string(static_cast<WorldStatus>(k)));
  for (std::size_t k = 0; k < texts.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) EXPECT_NE(texts[k], texts[i]);
  EXPECT_TRUE(is_failure(WorldStatus::stale_handle));
  EXPECT_FALSE(is_failure(WorldStatus::clamped));
}

}  // namespace
}  // namespace kerf::test

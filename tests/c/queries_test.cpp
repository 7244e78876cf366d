#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "core/c/kerf.h"

namespace kerf::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Unit squares at x = 0, 10, 20, 30, 40; the last one is a sensor.
class CQueries : public testing::Test {
 public:
  CQueries() {
    kerf_world* made = nullptr;
    EXPECT_EQ(kerf_world_create(2, nullptr, &made, nullptr), KERF_OK);
    world.reset(made);
    for (std::size_t k = 0; k < handles.size(); ++k) {
      kerf_object object{};
      EXPECT_EQ(kerf_object_init(&object, sizeof object), KERF_OK);
      if (k == 4) object.kind = KERF_SENSOR;
      object.margin = 2;
      const auto x = static_cast<float>(10 * k);
      const std::array<float, 4> box{x, 0, x + 1, 1};
      EXPECT_EQ(kerf_world_insert(world.get(), box.data(), &object, 1, 1, &handles[k], nullptr), KERF_OK);
    }
    EXPECT_EQ(kerf_query_filter_init(&filter, sizeof filter), KERF_OK);
    EXPECT_EQ(kerf_world_update_index(world.get()), KERF_OK);
  }

  struct Destroy {
    void operator()(kerf_world* made) const { kerf_world_destroy(made); }
  };
  std::unique_ptr<kerf_world, Destroy> world;
  std::array<kerf_handle, 5> handles{};
  kerf_query_filter filter{};
  const std::array<float, 4> all{-100, -100, 100, 100};
  const std::array<float, 4> left{-5, 0.5, -5, 0.5};  ///< a point
  const std::array<float, 2> right{1, 0};             ///< a direction
};

TEST_F(CQueries, FindWhatABoxOverlaps) {
  std::array<kerf_handle, 5> found{};
  std::size_t count = 9;
  const std::array<float, 4> box{1, 0, 10, 0.5};
  EXPECT_EQ(kerf_world_overlap_box(world.get(), box.data(), nullptr, found.data(), 5, &count), KERF_OK);
  EXPECT_EQ(count, 2U) << "boxes as given, without their margins";
  EXPECT_EQ(found, (std::array<kerf_handle, 5>{handles[0], handles[1], 0, 0, 0}));
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, found.data(), 2, &count),
            KERF_SMALL_BUFFER);
  EXPECT_EQ(count, 5U);
  EXPECT_EQ(found[1], handles[1]) << "the first ones are written";
  count = 0;
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 5U);
}

TEST_F(CQueries, FindWhatASphereOverlaps) {
  std::array<kerf_handle, 5> found{};
  std::size_t count = 0;
  const std::array<float, 2> center{5, 0};
  EXPECT_EQ(kerf_world_overlap_sphere(world.get(), center.data(), 4, nullptr, found.data(), 5, &count),
            KERF_OK);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(found[0], handles[0]);
}

TEST_F(CQueries, CastRaysAndBoxes) {
  std::array<kerf_hit, 5> found{};
  std::size_t count = 0;
  EXPECT_EQ(
      kerf_world_cast(world.get(), left.data(), right.data(), kInfinity, nullptr, found.data(), 5, &count),
      KERF_OK);
  ASSERT_EQ(count, 5U);
  EXPECT_EQ(found[1].object, handles[1]);
  EXPECT_EQ(found[1].t, 15);
  const std::array<float, 4> box{-5, -2, -4, -1};
  const std::array<float, 2> aslant{2, 0.5};
  kerf_hit first{};
  EXPECT_EQ(kerf_world_cast_first(world.get(), box.data(), aslant.data(), kInfinity, nullptr, &first),
            KERF_OK);
  EXPECT_EQ(first.object, handles[0]);
  EXPECT_EQ(first.t, 2);
  EXPECT_EQ(kerf_world_cast_first(world.get(), box.data(), aslant.data(), 1.5F, nullptr, &first), KERF_OK);
  EXPECT_EQ(first.object, 0U);
}

TEST_F(CQueries, FindTheNearest) {
  std::array<kerf_neighbour, 3> found{};
  std::size_t count = 0;
  const std::array<float, 2> point{12, 0};
  EXPECT_EQ(kerf_world_nearest(world.get(), point.data(), kInfinity, nullptr, found.data(), 3, &count),
            KERF_OK);
  ASSERT_EQ(count, 3U);
  EXPECT_EQ(found[0].object, handles[1]);
  EXPECT_EQ(found[0].squared_distance, 1);
  EXPECT_EQ(found[1].object, handles[2]);
  EXPECT_EQ(kerf_world_nearest(world.get(), point.data(), 2, nullptr, found.data(), 3, &count), KERF_OK);
  EXPECT_EQ(count, 1U);
}

TEST_F(CQueries, HaveFilters) {
  std::array<kerf_handle, 5> found{};
  std::size_t count = 0;
  const auto ask = [&] {
    return kerf_world_overlap_box(world.get(), all.data(), &filter, found.data(), 5, &count);
  };
  filter.kinds = 1U << static_cast<unsigned>(KERF_SENSOR);
  EXPECT_EQ(ask(), KERF_OK);
  EXPECT_EQ(count, 1U);
  filter.kinds = 0xF;
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[2], 4, 4, 0), KERF_OK);
  filter.category = 4;
  filter.mask = 4;
  EXPECT_EQ(ask(), KERF_OK);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(found[0], handles[2]);
  filter.category = filter.mask = UINT64_MAX;
  filter.context = &handles[3];
  filter.accepts = [](void* context, kerf_handle handle) {
    return handle == *static_cast<kerf_handle*>(context) ? 7 : 0;
  };
  EXPECT_EQ(ask(), KERF_OK);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(found[0], handles[3]);
  filter.size = 8;
  EXPECT_EQ(ask(), KERF_BAD_SIZE);
}

TEST_F(CQueries, WithoutAFilterOrWithAFreshOneFindEveryObject) {
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[1], 0, 0, 0), KERF_OK);
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[2], 2, 2, -1), KERF_OK);
  std::size_t count = 0;
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 5U);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), &filter, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 5U) << "as it is initialised";
  EXPECT_EQ(kerf_world_set_kind(world.get(), handles[1], KERF_FIXED), KERF_OK);
  filter.kinds = 1U << static_cast<unsigned>(KERF_FIXED);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), &filter, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 1U) << "one of an empty mask, by its kind";
}

TEST_F(CQueries, APartOfAFilterThatIsNotSetHasAllBits) {
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[1], 2, 8, 0), KERF_OK);
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[2], 4, 16, -3), KERF_OK);
  EXPECT_EQ(kerf_world_set_filter(world.get(), handles[3], 6, 24, 3), KERF_OK);
  const auto found = [&](std::uint64_t category, std::uint64_t mask, std::int32_t group) {
    filter.category = category;
    filter.mask = mask;
    filter.group = group;
    std::vector<kerf_handle> objects(5);
    std::size_t count = 0;
    EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), &filter, objects.data(), 5, &count), KERF_OK);
    objects.resize(count);
    return objects;
  };
  using Handles = std::vector<kerf_handle>;
  EXPECT_EQ(found(0, 2, 0), (Handles{handles[1], handles[3]})) << "of a category";
  EXPECT_EQ(found(16, 0, 0), (Handles{handles[0], handles[2], handles[3], handles[4]})) << "by their masks";
  EXPECT_EQ(found(0, 0, -3), (Handles{handles[0], handles[1], handles[3], handles[4]})) << "not of a group";
  EXPECT_EQ(found(8, 4, 0), Handles{handles[3]});
}

TEST_F(CQueries, NothingIsKnownAfterARestoreUntilTheIndexIsUpdated) {
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  std::size_t size = 0;
  ASSERT_EQ(kerf_world_save(world.get(), nullptr, 0, &size), KERF_OK);
  std::vector<unsigned char> bytes(size);
  ASSERT_EQ(kerf_world_save(world.get(), bytes.data(), size, &size), KERF_OK);
  const std::array<float, 4> far{500, 0, 501, 1};
  EXPECT_EQ(kerf_world_move(world.get(), handles.data(), far.data(), 1, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_update_index(world.get()), KERF_OK);
  ASSERT_EQ(kerf_world_restore(world.get(), bytes.data(), size, nullptr), KERF_OK);
  std::size_t count = 9;
  EXPECT_EQ(kerf_world_overlap_box(world.get(), far.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 0U) << "where it was in the other run";
  EXPECT_EQ(kerf_world_update_index(world.get()), KERF_OK);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 5U);
}

TEST_F(CQueries, ACallbackCannotChangeItsWorld) {
  filter.context = world.get();
  filter.accepts = [](void* context, kerf_handle handle) {
    auto* const asked = static_cast<kerf_world*>(context);
    EXPECT_EQ(kerf_world_remove(asked, &handle, 1, nullptr), KERF_BUSY);
    EXPECT_EQ(kerf_world_update_index(asked), KERF_BUSY);
    EXPECT_EQ(kerf_world_step(asked), KERF_BUSY);
    return kerf_world_contains(asked, handle) == KERF_OK ? 1 : 0;
  };
  std::size_t count = 0;
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), &filter, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 5U);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK) << "the query is over";
}

TEST_F(CQueries, LiesAreRefused) {
  std::array<kerf_handle, 5> found{};
  std::array<kerf_neighbour, 1> near{};
  kerf_hit hit{};
  std::size_t count = 0;
  const std::array<float, 4> bad{0, kNan, 1, 1};
  kerf_world* const it = world.get();
  EXPECT_EQ(kerf_world_overlap_box(it, bad.data(), nullptr, found.data(), 5, &count), KERF_BAD_QUERY);
  EXPECT_EQ(kerf_world_overlap_sphere(it, bad.data(), 1, nullptr, found.data(), 5, &count), KERF_BAD_QUERY);
  EXPECT_EQ(kerf_world_overlap_sphere(it, left.data(), -1, nullptr, found.data(), 5, &count), KERF_BAD_QUERY);
  EXPECT_EQ(kerf_world_cast(it, bad.data(), right.data(), 1, nullptr, &hit, 1, &count), KERF_BAD_QUERY);
  EXPECT_EQ(kerf_world_cast_first(it, left.data(), right.data(), kNan, nullptr, &hit), KERF_BAD_QUERY);
  EXPECT_EQ(kerf_world_nearest(it, bad.data(), 1, nullptr, near.data(), 1, &count), KERF_BAD_QUERY);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(kerf_world_overlap_box(nullptr, all.data(), nullptr, found.data(), 5, &count),
            KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_overlap_box(it, nullptr, nullptr, found.data(), 5, &count), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_overlap_box(it, all.data(), nullptr, nullptr, 5, &count), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_overlap_box(it, all.data(), nullptr, found.data(), 5, nullptr), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_overlap_sphere(it, nullptr, 1, nullptr, found.data(), 5, &count), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_cast(it, all.data(), nullptr, 1, nullptr, &hit, 1, &count), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_cast_first(it, all.data(), right.data(), 1, nullptr, nullptr), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_nearest(it, nullptr, 1, nullptr, near.data(), 1, &count), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_update_index(nullptr), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_query_filter_init(nullptr, 8), KERF_NULL_ARGUMENT);
}

TEST_F(CQueries, KnowNewObjectsAfterAnUpdate) {
  std::size_t count = 0;
  EXPECT_EQ(kerf_world_remove(world.get(), handles.data(), 2, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 3U) << "removed objects are not found";
  std::vector<kerf_handle> many(200);
  std::vector<float> boxes(800, 1);
  EXPECT_EQ(kerf_world_insert(world.get(), boxes.data(), nullptr, 0, 200, many.data(), nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(kerf_world_update_index(world.get()), KERF_OK);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), nullptr, nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 203U);
}

}  // namespace
}  // namespace kerf::test

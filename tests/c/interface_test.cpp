#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/c/kerf.h"

namespace kerf::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint64_t kSome = 12;

struct Destroy {
  void operator()(kerf_world* world) const { kerf_world_destroy(world); }
};
using Owned = std::unique_ptr<kerf_world, Destroy>;

Owned make_world(std::uint32_t dimension = 2, const kerf_world_options* options = nullptr) {
  kerf_world* world = nullptr;
  EXPECT_EQ(kerf_world_create(dimension, options, &world, nullptr), KERF_OK);
  return Owned(world);
}

std::vector<float> square(float x, float y, float half = 1) {
  return {x - half, y - half, x + half, y + half};
}

kerf_handle add(kerf_world* world, float x, std::uint32_t kind = KERF_MOVING) {
  kerf_object object{};
  EXPECT_EQ(kerf_object_init(&object, sizeof object), KERF_OK);
  object.kind = kind;
  kerf_handle handle = 0;
  EXPECT_EQ(kerf_world_insert(world, square(x, 0).data(), &object, 1, 1, &handle, nullptr), KERF_OK);
  return handle;
}

using Report = kerf_status (*)(const kerf_world*, const kerf_pair**, std::size_t*);

std::string text(const kerf_world* world, Report report) {
  const kerf_pair* pairs = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(report(world, &pairs, &count), KERF_OK);
  std::string all;
  for (std::size_t k = 0; k < count; ++k)
    all += (k == 0 ? "" : " ") + std::to_string(kerf_handle_index(pairs[k].a)) + "-" +
           std::to_string(kerf_handle_index(pairs[k].b)) + (pairs[k].flags == KERF_PAIR_OF_SENSOR ? "*" : "");
  return all;
}

TEST(CInterface, ReportsPairsInTwoAndThreeDimensions) {
  for (const std::uint32_t dimension : {2U, 3U}) {
    const Owned world = make_world(dimension);
    EXPECT_EQ(kerf_world_dimension(world.get()), dimension);
    const std::size_t floats = std::size_t{2} * dimension;
    std::vector<float> boxes(3 * floats);
    for (std::size_t k = 0; k < boxes.size(); ++k)
      boxes[k] = static_cast<float>(k / floats) + (k % floats < dimension ? 0.0F : 1.5F);
    std::array<kerf_handle, 3> handles{};
    std::array<kerf_status, 3> statuses{9, 9, 9};
    EXPECT_EQ(kerf_world_insert(world.get(), boxes.data(), nullptr, 0, 3, handles.data(), statuses.data()),
              KERF_OK);
    EXPECT_EQ(statuses, (std::array<kerf_status, 3>{}));
    EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
    EXPECT_EQ(text(world.get(), kerf_world_begun), "0-1 1-2");
    EXPECT_EQ(kerf_world_move(world.get(), handles.data(), boxes.data() + floats, 1, nullptr), KERF_OK);
    EXPECT_EQ(kerf_world_remove(world.get(), &handles[2], 1, nullptr), KERF_OK);
    EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
    EXPECT_EQ(text(world.get(), kerf_world_pairs) + "|" + text(world.get(), kerf_world_ended), "0-1|1-2");
    std::array<float, 6> box{};
    EXPECT_EQ(kerf_world_get_box(world.get(), handles[0], box.data()), KERF_OK);
    EXPECT_TRUE(std::equal(box.begin(), box.begin() + static_cast<std::ptrdiff_t>(floats),
                           boxes.begin() + static_cast<std::ptrdiff_t>(floats)));
    std::array<kerf_handle, 3> listed{};
    std::size_t count = 0;
    EXPECT_EQ(kerf_world_get_handles(world.get(), listed.data(), 3, &count), KERF_OK);
    EXPECT_EQ(count, kerf_world_size(world.get()));
    EXPECT_EQ(listed, (std::array<kerf_handle, 3>{handles[0], handles[1], 0}));
    EXPECT_EQ(kerf_world_bound(world.get()), 3U);
  }
}

TEST(CInterface, ObjectsAreWhatTheyWereMade) {
  const Owned world = make_world();
  kerf_object object{};
  ASSERT_EQ(kerf_object_init(&object, sizeof object), KERF_OK);
  object.kind = KERF_SENSOR;
  object.category = 6;
  object.mask = 5;
  object.group = -4;
  object.user_data = UINT64_MAX;
  object.margin = 0.5F;
  kerf_handle handle = 0;
  ASSERT_EQ(kerf_world_insert(world.get(), square(0, 0).data(), &object, 1, 1, &handle, nullptr), KERF_OK);
  kerf_object found{};
  found.size = sizeof found;
  ASSERT_EQ(kerf_world_get_object(world.get(), handle, &found), KERF_OK);
  EXPECT_EQ(std::memcmp(&found, &object, sizeof found), 0);
  std::array<float, 4> fat{};
  EXPECT_EQ(kerf_world_get_fat_box(world.get(), handle, fat.data()), KERF_OK);
  EXPECT_EQ(fat, (std::array<float, 4>{-1.5F, -1.5F, 1.5F, 1.5F}));

  EXPECT_EQ(kerf_world_set_kind(world.get(), handle, KERF_KINEMATIC), KERF_OK);
  EXPECT_EQ(kerf_world_set_filter(world.get(), handle, 1, 2, 3), KERF_OK);
  EXPECT_EQ(kerf_world_set_user_data(world.get(), handle, kSome), KERF_OK);
  EXPECT_EQ(kerf_world_set_margin(world.get(), handle, 0), KERF_OK);
  ASSERT_EQ(kerf_world_get_object(world.get(), handle, &found), KERF_OK);
  EXPECT_EQ(found.kind, static_cast<std::uint32_t>(KERF_KINEMATIC));
  EXPECT_EQ(found.category, 1U);
  EXPECT_EQ(found.mask, 2U);
  EXPECT_EQ(found.group, 3);
  EXPECT_EQ(found.user_data, kSome);
  EXPECT_EQ(found.margin, 0);
}

TEST(CInterface, SensorsAreFlagged) {
  const Owned world = make_world();
  add(world.get(), 0);
  add(world.get(), 0, KERF_SENSOR);
  add(world.get(), 0, KERF_FIXED);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  EXPECT_EQ(text(world.get(), kerf_world_pairs), "0-1* 0-2 1-2*");
}

/// What the callback of a test sees.
struct Seen {
  kerf_world* world;
  int calls = 0;
  kerf_status status = KERF_OK;
};

TEST(CInterface, ACallbackDecidesAndCannotChangeItsWorld) {
  const Owned world = make_world();
  for (int k = 0; k < 3; ++k) add(world.get(), 0);
  Seen seen{world.get()};
  const auto ask = [](void* context, const kerf_pair* pair) {
    Seen& self = *static_cast<Seen*>(context);
    ++self.calls;
    self.status = kerf_world_remove(self.world, &pair->a, 1, nullptr);
    EXPECT_EQ(kerf_world_step(self.world), KERF_BUSY);
    EXPECT_EQ(kerf_world_contains(self.world, pair->a), KERF_OK) << "const functions are allowed";
    std::size_t size = 0;
    EXPECT_EQ(kerf_world_save(self.world, nullptr, 0, &size), KERF_UNSTEPPED) << "the step is not done";
    return kerf_handle_index(pair->a) == 0 ? 1 : 0;
  };
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);  // so that the next one has no requests
  EXPECT_EQ(kerf_world_set_callback(world.get(), ask, &seen), KERF_OK);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  EXPECT_EQ(seen.calls, 3);
  EXPECT_EQ(seen.status, KERF_BUSY);
  EXPECT_EQ(text(world.get(), kerf_world_pairs), "0-1 0-2");
  EXPECT_EQ(kerf_world_set_callback(world.get(), nullptr, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  EXPECT_EQ(text(world.get(), kerf_world_begun), "1-2");
}

/// It is no fault of Kerf's, nor of its options or memory.
TEST(CInterface, WhatACallbackThrowsIsItsOwn) {
  const Owned world = make_world();
  for (int k = 0; k < 2; ++k) add(world.get(), 0);
  const auto ask = [](void*, const kerf_pair*) -> int { throw std::invalid_argument("mine"); };
  EXPECT_EQ(kerf_world_set_callback(world.get(), ask, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_CALLBACK_THREW);
  EXPECT_EQ(kerf_world_set_callback(world.get(), nullptr, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  kerf_query_filter filter{};
  ASSERT_EQ(kerf_query_filter_init(&filter, sizeof filter), KERF_OK);
  filter.accepts = [](void*, kerf_handle) -> int { throw 1; };
  const std::array<float, 4> all{-9, -9, 9, 9};
  std::size_t count = 0;
  EXPECT_EQ(kerf_world_update_index(world.get()), KERF_OK);
  EXPECT_EQ(kerf_world_overlap_box(world.get(), all.data(), &filter, nullptr, 0, &count),
            KERF_CALLBACK_THREW);
}

TEST(CInterface, AWorldIsSavedAndRestored) {
  const Owned world = make_world();
  const kerf_handle handle = add(world.get(), 0);
  add(world.get(), 1);
  std::size_t size = 0;
  EXPECT_EQ(kerf_world_save(world.get(), nullptr, 0, &size), KERF_UNSTEPPED);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  ASSERT_EQ(kerf_world_save(world.get(), nullptr, 0, &size), KERF_OK);
  std::vector<unsigned char> bytes(size);
  std::size_t again = 0;
  EXPECT_EQ(kerf_world_save(world.get(), bytes.data(), size - 1, &again), KERF_SMALL_BUFFER);
  EXPECT_EQ(again, size);
  ASSERT_EQ(kerf_world_save(world.get(), bytes.data(), size, &again), KERF_OK);
  const Owned other = make_world();
  kerf_error error{};
  ASSERT_EQ(kerf_error_init(&error, sizeof error), KERF_OK);
  bytes[size / 2] ^= 1U;
  EXPECT_EQ(kerf_world_restore(other.get(), bytes.data(), size, &error), KERF_DAMAGED);
  EXPECT_EQ(error.status, KERF_DAMAGED);
  EXPECT_NE(std::string(error.text).find("checksum"), std::string::npos) << error.text;
  bytes[size / 2] ^= 1U;
  EXPECT_EQ(kerf_world_restore(other.get(), bytes.data(), size, &error), KERF_OK);
  EXPECT_EQ(error.status, KERF_OK);
  EXPECT_STREQ(error.text, kerf_status_text(KERF_OK));
  EXPECT_EQ(kerf_world_contains(other.get(), handle), KERF_OK);
  EXPECT_EQ(text(other.get(), kerf_world_pairs), "0-1");
  EXPECT_EQ(kerf_world_restore(make_world(3).get(), bytes.data(), size, nullptr), KERF_DAMAGED);
}

TEST(CInterface, OptionsAreTaken) {
  kerf_world_options options{};
  ASSERT_EQ(kerf_world_options_init(&options, sizeof options), KERF_OK);
  options.tag = 200;
  options.pairs_of = KERF_PAIRS_OF_EXACT_BOXES;
  options.config = "min_threshold=4";
  const Owned world = make_world(2, &options);
  EXPECT_EQ(add(world.get(), 0) >> 56U, 200U);
  add(world.get(), 2.5F);
  EXPECT_EQ(kerf_world_set_margin(world.get(), add(world.get(), 9), 5), KERF_OK);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
  EXPECT_EQ(text(world.get(), kerf_world_pairs), "");
}

/// A struct of a later version.
struct LaterObject {
  kerf_object object;
  std::uint64_t more;
};

TEST(CInterface, StructsHaveTheSizeOfTheirVersion) {
  const Owned world = make_world();
  const std::vector<float> box = square(0, 0);
  std::array<LaterObject, 2> later{};
  std::array<kerf_handle, 2> handles{};
  std::vector<float> boxes = box;
  boxes.insert(boxes.end(), box.begin(), box.end());
  const auto insert = [&] {
    return kerf_world_insert(world.get(), boxes.data(), &later[0].object, 2, 2, handles.data(), nullptr);
  };
  for (LaterObject& object : later) ASSERT_EQ(kerf_object_init(&object.object, sizeof object), KERF_OK);
  later[1].object.user_data = kSome;
  EXPECT_EQ(insert(), KERF_OK);
  kerf_object found{};
  found.size = sizeof found;
  EXPECT_EQ(kerf_world_get_object(world.get(), handles[1], &found), KERF_OK);
  EXPECT_EQ(found.user_data, kSome) << "objects lie as far apart as their size says";
  const kerf_handle first = handles[0];
  later[1].more = 1;
  EXPECT_EQ(insert(), KERF_BAD_SIZE) << "a member that this version does not know";
  later[1].more = 0;
  later[1].object.size = sizeof(kerf_object);
  EXPECT_EQ(insert(), KERF_BAD_SIZE) << "two sizes in one list";
  EXPECT_EQ(kerf_world_size(world.get()), 2U);

  LaterObject wide{};
  wide.object.size = sizeof wide;
  wide.more = kSome;
  EXPECT_EQ(kerf_world_get_object(world.get(), first, &wide.object), KERF_OK);
  EXPECT_EQ(wide.more, 0U);
  EXPECT_EQ(wide.object.size, sizeof wide);
}

TEST(CInterface, SizesThatAreTooSmallAreRefused) {
  const Owned world = make_world();
  const kerf_handle handle = add(world.get(), 0);
  kerf_object object{};
  kerf_handle given = 0;
  for (const std::uint32_t size : {0U, 4U, 39U}) {
    EXPECT_EQ(kerf_object_init(&object, size), KERF_BAD_SIZE);
    object.size = size;
    EXPECT_EQ(kerf_world_insert(world.get(), square(0, 0).data(), &object, 1, 1, &given, nullptr),
              KERF_BAD_SIZE);
    EXPECT_EQ(kerf_world_get_object(world.get(), handle, &object), KERF_BAD_SIZE);
  }
  kerf_world_options options{};
  EXPECT_EQ(kerf_world_options_init(&options, 8), KERF_BAD_SIZE);
  kerf_world* none = nullptr;
  EXPECT_EQ(kerf_world_create(2, &options, &none, nullptr), KERF_BAD_SIZE);
  kerf_error error{};
  EXPECT_EQ(kerf_error_init(&error, 12), KERF_BAD_SIZE);
  error.size = 12;
  EXPECT_EQ(kerf_world_create(7, nullptr, &none, &error), KERF_BAD_OPTION);
  EXPECT_EQ(error.text[0], '\0') << "there is no room for a text";
  error.size = 24 + 8;
  EXPECT_EQ(kerf_world_create(7, nullptr, &none, &error), KERF_BAD_OPTION);
  EXPECT_STREQ(error.text, "dimension is ...");
}

TEST(CInterface, NullIsRefused) {
  const Owned owned = make_world();
  kerf_world* const world = owned.get();
  kerf_handle handle = add(world, 0);
  const std::vector<float> box = square(0, 0);
  std::array<float, 4> to{};
  const kerf_pair* pairs = nullptr;
  std::size_t count = 0;
  kerf_object object{};
  const std::vector<kerf_status> answers{
      kerf_world_create(2, nullptr, nullptr, nullptr),
      kerf_world_options_init(nullptr, 8),
      kerf_object_init(nullptr, 8),
      kerf_error_init(nullptr, 8),
      kerf_world_insert(nullptr, box.data(), nullptr, 0, 1, &handle, nullptr),
      kerf_world_insert(world, nullptr, nullptr, 0, 1, &handle, nullptr),
      kerf_world_insert(world, box.data(), nullptr, 1, 1, &handle, nullptr),
      kerf_world_insert(world, box.data(), nullptr, 0, 1, nullptr, nullptr),
      kerf_world_move(nullptr, &handle, box.data(), 1, nullptr),
      kerf_world_move(world, nullptr, box.data(), 1, nullptr),
      kerf_world_move(world, &handle, nullptr, 1, nullptr),
      kerf_world_remove(nullptr, &handle, 1, nullptr),
      kerf_world_remove(world, nullptr, 1, nullptr),
      kerf_world_set_kind(nullptr, handle, 0),
      kerf_world_set_filter(nullptr, handle, 0, 0, 0),
      kerf_world_set_user_data(nullptr, handle, 0),
      kerf_world_set_margin(nullptr, handle, 0),
      kerf_world_shift_origin(nullptr, to.data()),
      kerf_world_shift_origin(world, nullptr),
      kerf_world_set_callback(nullptr, nullptr, nullptr),
      kerf_world_set_threads(nullptr, 1),
      kerf_world_step(nullptr),
      kerf_world_pairs(nullptr, &pairs, &count),
      kerf_world_pairs(world, nullptr, &count),
      kerf_world_begun(world, &pairs, nullptr),
      kerf_world_ended(world, nullptr, nullptr),
      kerf_world_contains(nullptr, handle),
      kerf_world_get_object(nullptr, handle, &object),
      kerf_world_get_object(world, handle, nullptr),
      kerf_world_get_box(nullptr, handle, to.data()),
      kerf_world_get_box(world, handle, nullptr),
      kerf_world_get_fat_box(world, handle, nullptr),
      kerf_world_get_handles(world, nullptr, 1, &count),
      kerf_world_get_handles(world, nullptr, 0, nullptr),
      kerf_world_save(world, nullptr, 1, &count),
      kerf_world_save(world, nullptr, 0, nullptr),
      kerf_world_restore(world, nullptr, 1, nullptr),
  };
  for (std::size_t k = 0; k < answers.size(); ++k) EXPECT_EQ(answers[k], KERF_NULL_ARGUMENT) << "call " << k;
  kerf_world_destroy(nullptr);
  EXPECT_EQ(kerf_world_size(nullptr) + kerf_world_bound(nullptr) + kerf_world_dimension(nullptr), 0U);
  EXPECT_EQ(kerf_world_size(world), 1U);
}

TEST(CInterface, ListsOfNoElementsMayBeNull) {
  const Owned world = make_world();
  EXPECT_EQ(kerf_world_insert(world.get(), nullptr, nullptr, 0, 0, nullptr, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_move(world.get(), nullptr, nullptr, 0, nullptr), KERF_OK);
  EXPECT_EQ(kerf_world_remove(world.get(), nullptr, 0, nullptr), KERF_OK);
  std::size_t count = 9;
  EXPECT_EQ(kerf_world_get_handles(world.get(), nullptr, 0, &count), KERF_OK);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(kerf_world_restore(world.get(), nullptr, 0, nullptr), KERF_DAMAGED);
}

TEST(CInterface, BadBoxesAndStaleHandlesHaveStatusesOfTheirOwn) {
  const Owned world = make_world();
  const kerf_handle handle = add(world.get(), 0);
  const kerf_handle gone = add(world.get(), 0);
  EXPECT_EQ(kerf_world_remove(world.get(), &gone, 1, nullptr), KERF_OK);
  const std::vector<kerf_handle> handles{handle, gone, handle, 0, UINT64_MAX, handle};
  std::vector<float> boxes;
  for (std::size_t k = 0; k < handles.size(); ++k)
    for (const float x : square(static_cast<float>(k), 0)) boxes.push_back(x);
  boxes[1] = kNan;
  boxes[2 * 4] = kInfinity;  // above its maximum
  boxes[5 * 4] = -kInfinity;
  std::vector<kerf_status> statuses(handles.size(), -1);
  EXPECT_EQ(kerf_world_move(world.get(), handles.data(), boxes.data(), handles.size(), statuses.data()),
            KERF_BAD_BOX);
  EXPECT_EQ(statuses, (std::vector<kerf_status>{KERF_BAD_BOX, KERF_STALE_HANDLE, KERF_BAD_BOX,
                                                KERF_STALE_HANDLE, KERF_STALE_HANDLE, KERF_CLAMPED}));
  std::array<float, 4> box{};
  EXPECT_EQ(kerf_world_get_box(world.get(), handle, box.data()), KERF_OK);
  EXPECT_EQ(box[0], -std::numeric_limits<float>::max());
  EXPECT_EQ(kerf_world_set_margin(world.get(), handle, kNan), KERF_BAD_VALUE);
  const std::array<float, 2> nowhere{0, kNan};
  EXPECT_EQ(kerf_world_shift_origin(world.get(), nowhere.data()), KERF_BAD_VALUE);
  for (const std::uint32_t kind : {4U, 255U, 256U, UINT32_MAX})
    EXPECT_EQ(kerf_world_set_kind(world.get(), handle, kind), KERF_BAD_VALUE);
  EXPECT_EQ(kerf_world_set_threads(world.get(), 0), KERF_BAD_OPTION);
  EXPECT_EQ(kerf_world_set_threads(world.get(), UINT32_MAX), KERF_BAD_OPTION);
  kerf_handle some = 0;
  std::array<kerf_object, 3> objects{};
  for (kerf_object& object : objects) ASSERT_EQ(kerf_object_init(&object, sizeof object), KERF_OK);
  EXPECT_EQ(kerf_world_insert(world.get(), boxes.data(), objects.data(), 3, 1, &some, nullptr),
            KERF_BAD_LENGTH);
}

TEST(CInterface, MemoryThatCannotBeIsAStatus) {
  const Owned world = make_world();
  const kerf_handle handle = add(world.get(), 0);
  kerf_status status = 0;
  EXPECT_EQ(kerf_world_move(world.get(), &handle, square(0, 0).data(), SIZE_MAX, &status),
            KERF_OUT_OF_MEMORY);
  EXPECT_EQ(kerf_world_remove(world.get(), &handle, SIZE_MAX, &status), KERF_OUT_OF_MEMORY);
  EXPECT_EQ(kerf_world_step(world.get()), KERF_OK);
}

}  // namespace
}  // namespace kerf::test

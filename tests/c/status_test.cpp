#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

#include "core/c/kerf.h"

namespace kerf::test {
namespace {

TEST(CInterface, EachStatusHasAText) {
  for (kerf_status status = -3; status < 80; ++status) {
    const char* const sentence = kerf_status_text(status);
    ASSERT_NE(sentence, nullptr);
    const bool is_known = (status >= KERF_OK && status <= KERF_DAMAGED) ||
                          (status >= KERF_NULL_ARGUMENT && status <= KERF_CALLBACK_THREW);
    EXPECT_EQ(std::string(sentence) != "no status of Kerf's", is_known) << status;
  }
  EXPECT_EQ(std::string(kerf_version()).find("0."), 0U);
}

TEST(CInterface, OptionsThatCannotWorkAreNamed) {
  const auto why = [](auto change, std::uint32_t dimension = 2) {
    kerf_world_options options{};
    EXPECT_EQ(kerf_world_options_init(&options, sizeof options), KERF_OK);
    change(options);
    kerf_error error{};
    EXPECT_EQ(kerf_error_init(&error, sizeof error), KERF_OK);
    kerf_world* world = nullptr;
    EXPECT_EQ(kerf_world_create(dimension, &options, &world, &error), KERF_BAD_OPTION);
    EXPECT_EQ(world, nullptr);
    EXPECT_EQ(error.status, KERF_BAD_OPTION);
    return std::string(error.text);
  };
  const auto nothing = [](kerf_world_options&) {};
  EXPECT_NE(why([](auto& options) { options.config = "max_height=99"; }).find("max_height"),
            std::string::npos);
  EXPECT_NE(why([](auto& options) { options.config = "what=1"; }).find("what"), std::string::npos);
  EXPECT_NE(why([](auto& options) { options.tag = 256; }).find("tag"), std::string::npos);
  EXPECT_NE(why([](auto& options) { options.pairs_of = 2; }).find("pairs_of"), std::string::npos);
  EXPECT_NE(why([](auto& options) { options.threads = 0; }), "");
  EXPECT_NE(why([](auto& options) { options.threads = 257; }).find("at most 256"), std::string::npos);
  EXPECT_NE(why(nothing, 4).find("dimension"), std::string::npos);
  EXPECT_NE(why(nothing, 0).find("dimension"), std::string::npos);
}

/// The list of parameters was cut within a word.
TEST(CInterface, ATextThatIsTooLongEndsAfterAWord) {
  const auto why = [](std::uint32_t dimension, const std::string& config, std::size_t room) {
    kerf_world_options options{};
    EXPECT_EQ(kerf_world_options_init(&options, sizeof options), KERF_OK);
    options.config = config.c_str();
    kerf_error error{};
    EXPECT_EQ(kerf_error_init(&error, offsetof(kerf_error, text) + room), KERF_OK);
    kerf_world* world = nullptr;
    EXPECT_EQ(kerf_world_create(dimension, &options, &world, &error), KERF_BAD_OPTION);
    return std::string(error.text);
  };
  constexpr std::size_t kRoom = sizeof kerf_error::text;
  const std::string whole = why(7, "", kRoom);
  EXPECT_EQ(why(7, "", whole.size() + 1), whole);
  for (std::size_t room = 16; room <= whole.size(); ++room) {
    const std::string text = why(7, "", room);
    ASSERT_LT(text.size(), room);
    ASSERT_TRUE(text.ends_with(" ...")) << text;
    EXPECT_TRUE(whole.starts_with(text.substr(0, text.size() - 3))) << "whole words: " << text;
  }
  EXPECT_TRUE(why(2, "what=1", kRoom).ends_with(" ..."));
  EXPECT_GT(why(2, "what=1", kRoom).size(), kRoom - 30);
  EXPECT_EQ(why(2, std::string(300, 'x'), kRoom).size(), kRoom - 1) << "there is no blank";
}

/// What a callback saw of a batch.
struct Refused {
  kerf_world* world;
  std::array<kerf_handle, 2> handles{9, 9};
  std::array<kerf_status, 2> statuses{-1, -1};
};

TEST(CInterface, ARefusedInsertWritesNoHandlesAndNoStatuses) {
  kerf_world* world = nullptr;
  ASSERT_EQ(kerf_world_create(2, nullptr, &world, nullptr), KERF_OK);
  const std::array<float, 8> boxes{0, 0, 1, 1, 0, 0, 1, 1};
  std::array<kerf_object, 3> objects{};
  for (kerf_object& object : objects) ASSERT_EQ(kerf_object_init(&object, sizeof object), KERF_OK);
  const auto insert = [&](kerf_world* into, const float* of, std::size_t object_count) {
    Refused refused{into};
    const kerf_status status = kerf_world_insert(into, of, objects.data(), object_count, 2,
                                                 refused.handles.data(), refused.statuses.data());
    EXPECT_EQ(refused.handles, (std::array<kerf_handle, 2>{0, 0}));
    EXPECT_EQ(refused.statuses, (std::array<kerf_status, 2>{-1, -1}));
    return status;
  };
  EXPECT_EQ(insert(nullptr, boxes.data(), 1), KERF_NULL_ARGUMENT);
  EXPECT_EQ(insert(world, nullptr, 1), KERF_NULL_ARGUMENT);
  EXPECT_EQ(insert(world, boxes.data(), 3), KERF_BAD_LENGTH);
  objects[1].size = 4;
  EXPECT_EQ(insert(world, boxes.data(), 2), KERF_BAD_SIZE);

  std::array<kerf_handle, 2> handles{};
  EXPECT_EQ(kerf_world_insert(world, boxes.data(), nullptr, 0, 2, handles.data(), nullptr), KERF_OK);
  Refused refused{world};
  const auto ask = [](void* context, const kerf_pair*) {
    Refused& self = *static_cast<Refused*>(context);
    const std::array<float, 8> two{};
    EXPECT_EQ(
        kerf_world_insert(self.world, two.data(), nullptr, 0, 2, self.handles.data(), self.statuses.data()),
        KERF_BUSY);
    return 1;
  };
  EXPECT_EQ(kerf_world_set_callback(world, ask, &refused), KERF_OK);
  EXPECT_EQ(kerf_world_step(world), KERF_OK);
  EXPECT_EQ(refused.handles, (std::array<kerf_handle, 2>{0, 0}));
  EXPECT_EQ(refused.statuses, (std::array<kerf_status, 2>{-1, -1}));
  kerf_world_destroy(world);
}

TEST(CInterface, AnErrorIsThatOfTheLastCall) {
  kerf_error error{};
  ASSERT_EQ(kerf_error_init(&error, sizeof error), KERF_OK);
  kerf_world_options options{};
  ASSERT_EQ(kerf_world_options_init(&options, sizeof options), KERF_OK);
  options.config = "what=1";
  kerf_world* world = nullptr;
  EXPECT_EQ(kerf_world_create(2, &options, &world, &error), KERF_BAD_OPTION);
  options.size = 4;
  EXPECT_EQ(kerf_world_create(2, &options, &world, &error), KERF_BAD_SIZE);
  EXPECT_EQ(error.status, KERF_BAD_SIZE);
  EXPECT_STREQ(error.text, kerf_status_text(KERF_BAD_SIZE));
  EXPECT_EQ(kerf_world_create(2, nullptr, nullptr, &error), KERF_NULL_ARGUMENT);
  EXPECT_EQ(error.status, KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_restore(nullptr, &options, 4, &error), KERF_NULL_ARGUMENT);
  EXPECT_EQ(kerf_world_create(2, nullptr, &world, &error), KERF_OK);
  EXPECT_EQ(error.status, KERF_OK);
  kerf_world_destroy(world);
}

}  // namespace
}  // namespace kerf::test

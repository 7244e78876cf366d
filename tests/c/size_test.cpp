// Sizes of structs that were never set: as large as what lay in the memory before.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "core/c/kerf.h"

namespace kerf::test {
namespace {

constexpr std::array kTooLarge{std::uint32_t{4097}, std::uint32_t{1} << 16U, std::uint32_t{0xCCCCCCC8},
                               UINT32_MAX};
constexpr std::array kSquare{0.0F, 0.0F, 1.0F, 1.0F};

class CSizes : public testing::Test {
 protected:
  void SetUp() override {
    kerf_world* made = nullptr;
    ASSERT_EQ(kerf_world_create(2, nullptr, &made, nullptr), KERF_OK);
    world_ = {made, kerf_world_destroy};
    ASSERT_EQ(kerf_world_insert(made, kSquare.data(), nullptr, 0, 1, &handle_, nullptr), KERF_OK);
  }
  std::unique_ptr<kerf_world, void (*)(kerf_world*)> world_{nullptr, kerf_world_destroy};
  kerf_handle handle_ = 0;
};

TEST_F(CSizes, ThatAreTooLargeAreRefusedAndNothingIsTouched) {
  for (const std::uint32_t size : kTooLarge) {
    kerf_object object{};
    EXPECT_EQ(kerf_object_init(&object, size), KERF_BAD_SIZE);
    object.size = size;
    EXPECT_EQ(kerf_world_get_object(world_.get(), handle_, &object), KERF_BAD_SIZE);
    kerf_handle none = 0;
    EXPECT_EQ(kerf_world_insert(world_.get(), kSquare.data(), &object, 1, 1, &none, nullptr), KERF_BAD_SIZE);
    kerf_world_options options{};
    EXPECT_EQ(kerf_world_options_init(&options, size), KERF_BAD_SIZE);
    kerf_query_filter filter{};
    EXPECT_EQ(kerf_query_filter_init(&filter, size), KERF_BAD_SIZE);
    filter.size = size;
    std::size_t count = 0;
    EXPECT_EQ(kerf_world_overlap_box(world_.get(), kSquare.data(), &filter, nullptr, 0, &count),
              KERF_BAD_SIZE);
    kerf_error error{};
    EXPECT_EQ(kerf_error_init(&error, size), KERF_BAD_SIZE);
    error.size = size;
    EXPECT_EQ(kerf_world_restore(world_.get(), nullptr, 1, &error), KERF_NULL_ARGUMENT);
    EXPECT_EQ(error.text[0], '\0') << "who knows how much memory it has";
  }
  EXPECT_EQ(kerf_world_size(world_.get()), 1U);
}

TEST_F(CSizes, TheErrorNamesBoth) {
  kerf_error error{};
  ASSERT_EQ(kerf_error_init(&error, sizeof error), KERF_OK);
  kerf_world_options options{};
  options.size = 0xCCCCCCC8;
  kerf_world* none = nullptr;
  EXPECT_EQ(kerf_world_create(2, &options, &none, &error), KERF_BAD_SIZE);
  EXPECT_EQ(none, nullptr);
  const std::string text(error.text);
  for (const std::string& part : {std::to_string(options.size), std::to_string(sizeof options),
                                  std::string("4096"), std::string("kerf_world_options_init")})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// What a later version may have: up to 4096 bytes, of which those that are not known are 0.
TEST_F(CSizes, OfLaterVersionsAreTaken) {
  struct Later {
    kerf_object object;
    std::array<unsigned char, 4096 - sizeof(kerf_object)> more;
  } later{};
  ASSERT_EQ(kerf_object_init(&later.object, sizeof later), KERF_OK);
  kerf_handle other = 0;
  EXPECT_EQ(kerf_world_insert(world_.get(), kSquare.data(), &later.object, 1, 1, &other, nullptr), KERF_OK);
  later.more.back() = 1;
  EXPECT_EQ(kerf_world_get_object(world_.get(), other, &later.object), KERF_OK);
  EXPECT_EQ(later.more.back(), 0);
  later.more.back() = 1;
  EXPECT_EQ(kerf_world_insert(world_.get(), kSquare.data(), &later.object, 1, 1, &other, nullptr),
            KERF_BAD_SIZE);
}

TEST_F(CSizes, AReservedMemberMustBe0) {
  kerf_query_filter filter{};
  ASSERT_EQ(kerf_query_filter_init(&filter, sizeof filter), KERF_OK);
  filter.reserved = 1;
  std::size_t count = 0;
  const auto ask = [&] {
    return kerf_world_overlap_box(world_.get(), kSquare.data(), &filter, nullptr, 0, &count);
  };
  EXPECT_EQ(ask(), KERF_BAD_SIZE);
  EXPECT_NE(std::string(kerf_status_text(KERF_BAD_SIZE)).find("reserved"), std::string::npos);
  filter.reserved = 0;
  EXPECT_EQ(ask(), KERF_OK);
}

}  // namespace
}  // namespace kerf::test

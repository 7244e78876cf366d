#include "frames/support/json_number.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

using Json = nlohmann::json;

TEST(JsonNumber, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(whole_number<std::uint32_t>(Json(4294967295), "n"), 4294967295U);
  EXPECT_EQ(whole_number<int>(Json(-5), "n"), -5);
  for (const char* const text : {"4294967296", "-1", "1.5", "1e300", "true", "null", "\"1\"", "[1]"})
    EXPECT_THROW((void)whole_number<std::uint32_t>(Json::parse(text), "n"), std::out_of_range) << text;
  EXPECT_THROW((void)whole_number<int>(Json(18446744073709551615U), "n"), std::out_of_range);
}

TEST(JsonNumber, FloatsAreFinite) {
  EXPECT_EQ(float_number(Json(29.83), "x"), 29.83F);
  EXPECT_EQ(float_number(Json(-1), "x"), -1.0F);
  for (const char* const text : {"1e39", "-1e300", "true", "null", "\"1\""})
    EXPECT_THROW((void)float_number(Json::parse(text), "x"), std::out_of_range) << text;
}

}  // namespace
}  // namespace kerf

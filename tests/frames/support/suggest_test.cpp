#include "frames/support/suggest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace kerf {
namespace {

const std::vector<std::string> kNames{"terrain", "buckets", "pile"};

TEST(Suggest, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("pile", "pile"), 0U);
  EXPECT_EQ(edit_distance("", "pile"), 4U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3U);
}

TEST(Suggest, CapitalsDoNotCount) { EXPECT_EQ(edit_distance("PILE", "pile"), 0U); }

TEST(Suggest, FindsTheNearestName) {
  EXPECT_EQ(nearest_name("buckts", kNames), "buckets");
  EXPECT_EQ(nearest_name("Terain", kNames), "terrain");
  EXPECT_EQ(nearest_name("pil", kNames), "pile");
}

TEST(Suggest, KeepsQuietWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("xyzzy", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
}

TEST(Suggest, MessageNamesEverythingValid) {
  EXPECT_EQ(unknown_name_message("scene", "buckts", kNames),
            "unknown scene 'buckts'; did you mean 'buckets'? Choose from: terrain, buckets, pile");
  EXPECT_EQ(unknown_name_message("scene", "xyzzy", kNames),
            "unknown scene 'xyzzy'. Choose from: terrain, buckets, pile");
}

}  // namespace
}  // namespace kerf

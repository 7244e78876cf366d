#include "frames/support/picture_size.h"

#include <gtest/gtest.h>

#include "frames/support/errors.h"

namespace kerf {
namespace {

TEST(PictureSize, ReadsWidthAndHeight) {
  EXPECT_EQ(parse_picture_size("1280x720"), (PictureSize{1280, 720}));
  EXPECT_EQ(parse_picture_size("64X8192"), (PictureSize{64, 8192}));
}

class BadSize : public ::testing::TestWithParam<const char*> {};

TEST_P(BadSize, IsRefused) { EXPECT_THROW((void)parse_picture_size(GetParam()), UsageError); }

INSTANTIATE_TEST_SUITE_P(PictureSize, BadSize,
                         ::testing::Values("", "x", "1280", "1280x", "x720", "0x720", "1280x0", "63x720",
                                           "1280x8193", "-1280x720", "1280x720x3", "1e3x720",
                                           "99999999999x720", "1280 x 720"));

}  // namespace
}  // namespace kerf

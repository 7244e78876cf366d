#include "viz/draw/letters.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Letters, AreCountedAndCutWhole) {
  EXPECT_EQ(count_letters(""), 0U);
  EXPECT_EQ(count_letters("a\xc3\xa4\xe2\x82\xac"), 3U);
  EXPECT_EQ(first_letters("a\xc3\xa4z", 2), "a\xc3\xa4");
  EXPECT_EQ(first_letters("a\xc3\xa4z", 9), "a\xc3\xa4z");
  EXPECT_EQ(count_letters("\xff\xc3"), 2U) << "bytes that are no UTF-8 are letters, too";
}

TEST(Letters, AShortenedTextSaysSo) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abc...");
  EXPECT_EQ(shortened("abcdefg", 2), "..");
  EXPECT_EQ(shortened("abcdefg", 0), "");
  EXPECT_EQ(shortened("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9f", 4), "\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9f");
  EXPECT_EQ(shortened("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9fxyz", 5), "\xc3\xa4\xc3\xb6...")
      << "no letter is halved";
}

}  // namespace
}  // namespace kerf

#include "viz/debugger/gui/wrap.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Wrap, NumbersStayWhole) {
  EXPECT_EQ(wrap_at_spaces("direction 2, z = -16.3868, balance 0.881579", 16),
            "direction 2, z =\n-16.3868,\nbalance 0.881579");
  EXPECT_EQ(wrap_at_spaces("z [-16.3868, 2]", 8), "z\n[-16.386\n8, 2]") << "cut only where it must be";
}

TEST(Wrap, LinesAndIndentsAreKept) {
  EXPECT_EQ(wrap_at_spaces("one\n\n  two three\n", 8), "one\n\n  two\n  three\n");
  EXPECT_EQ(wrap_at_spaces("", 8), "");
  EXPECT_EQ(wrap_at_spaces("ab   cd", 3), "ab \ncd");
  EXPECT_EQ(wrap_at_spaces("  abcdef", 5), "  abc\n  def");
  EXPECT_EQ(wrap_at_spaces("  abcdef", 4), "  ab\ncdef") << "an indent leaves room for more than itself";
  EXPECT_EQ(wrap_at_spaces("abc", 0), "a\nb\nc");
}

TEST(Wrap, CountsLettersAndHalvesNone) {
  EXPECT_EQ(wrap_at_spaces("\xc3\xa4\xc3\xb6\xc3\xbc \xc3\x9f", 5), "\xc3\xa4\xc3\xb6\xc3\xbc \xc3\x9f");
  EXPECT_EQ(wrap_at_spaces("\xc3\xa4\xc3\xb6\xc3\xbc", 2), "\xc3\xa4\xc3\xb6\n\xc3\xbc");
}

}  // namespace
}  // namespace kerf

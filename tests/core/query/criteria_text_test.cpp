#include "core/query/criteria_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

template <class T>
class CriteriaText : public testing::Test {};
TYPED_TEST_SUITE(CriteriaText, Dimensions, DimensionNames);

TYPED_TEST(CriteriaText, SaysWhyAnUnbalancedNodeMayStay) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> boxes(8, slab<kD>(0, 1));
  boxes.resize(10, slab<kD>(8, 9));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 5);
  const auto wish = [&](const char* config) {
    return wish_text(tree, tree.root(), config_of(config), GivenNames{});
  };
  const char* const stays = "it stays, since a swap would insert 2 objects beside 8, more than 10 %";
  EXPECT_THAT(wish(""), HasSubstr("unbalanced: its balance 0.25 is below 0.5"));
  EXPECT_THAT(wish(""), HasSubstr(stays));
  EXPECT_THAT(wish("swap_share=0.25"), Not(HasSubstr("stays")));
  EXPECT_THAT(wish("swap=0"), Not(HasSubstr("stays")));
  EXPECT_THAT(wish("min_balance=0.2"), Not(HasSubstr("stays"))) << "it is balanced";
}

}  // namespace
}  // namespace kerf::test

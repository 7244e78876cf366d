#include "frames/study/measure.h"

#include <gtest/gtest.h>

#include "frames/catalog/algorithm.h"

namespace kerf {
namespace {

/// Sort-and-sweep of more than 5,000 objects was judged by itself, and so was brute force with vectors of
/// fewer.
TEST(StudyOracle, IsNeverTheBroadPhaseThatItJudges) {
  for (const std::uint32_t objects : {1U, 5000U, 5001U, 1'000'000U})
    for (const Algorithm<3>& algorithm : algorithms<3>()) {
      const std::string oracle(oracle_for(objects, algorithm.name));
      EXPECT_NE(oracle, algorithm.name) << objects;
      ASSERT_TRUE(find_algorithm<2>(oracle));
      ASSERT_TRUE(find_algorithm<3>(oracle));
    }
}

}  // namespace
}  // namespace kerf

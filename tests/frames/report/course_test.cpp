// What the report says of errors, held against motions of which the truth is known.

#include "frames/report/course.h"

#include <gtest/gtest.h>

#include "core/broad_phase/approximate.h"
#include "core/bsp/bsp.h"

namespace kerf {
namespace {

void do_not_stop() {}

/// Two unit boxes: the second comes along the first axis, half a unit a step, from 3 to 0.
class Approach final : public Motion<2> {
 public:
  Approach() : Motion<2>(1) {
    boxes_ = {{{{0, 0}}, {{1, 1}}}, {{{3, 0}}, {{4, 1}}}};
    moving_ = 2;
    bounds_ = {{{-1, -1}}, {{5, 2}}};
  }
  void advance() override {
    boxes_[1].min[0] -= 0.5F;
    boxes_[1].max[0] -= 0.5F;
  }
};

Json figures_of(const Approximation& how) {
  Approach motion;
  const Course<2> course = record<2>(motion, 1, 5, do_not_stop);
  return run_course<2>(
      course, [&] { return std::make_unique<Approximate<2>>(std::make_unique<Bsp<2>>(), how); }, 1,
      do_not_stop);
}

/// Boxes at 2.5 in the step of the warm-up, then at 2, 1.5, 1, 0.5 and 0: the last three overlap.
TEST(Course, AnExactRunMissesNothing) {
  const Json figures = figures_of({});
  EXPECT_EQ(figures["true_pairs"], 3);
  EXPECT_EQ(figures["reported"], 3);
  EXPECT_EQ(figures["missed"], 0);
  EXPECT_EQ(figures["extra"], 0);
  EXPECT_EQ(figures["lag_max"], 0);
  EXPECT_GT(figures["mean_ns"], 0);
  EXPECT_GE(figures["max_ns"], figures["median_ns"]);
}

/// The first step is a placement, and then every fourth: at 3 and at 1.
TEST(Course, APeriodIsLate) {
  const Json figures = figures_of({.period = 4});
  EXPECT_EQ(figures["missed"], 0) << "the placement of step 4 comes just in time";
  const Json late = figures_of({.period = 5});
  EXPECT_EQ(late["missed"], 1) << "at 1; from 0.5 on it is reported";
  EXPECT_DOUBLE_EQ(late["missed_share"], 1.0 / 3);
  EXPECT_EQ(late["lag_max"], 1);
}

TEST(Course, AMarginReportsMore) {
  const Json figures = figures_of({.margin = 0.3F});
  EXPECT_EQ(figures["missed"], 0);
  EXPECT_EQ(figures["extra"], 1) << "at 1.5 the widened boxes overlap";
}

}  // namespace
}  // namespace kerf

#include "frames/bench/scene_properties.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

/// Four boxes of which one flies by half a size a step, one rests, one comes and goes; one is ten times as
/// large and rests.
class FourBoxes final : public Motion<2> {
 public:
  FourBoxes() : Motion<2>(1) {
    all_move_ = false;
    most_changes_ = 1;
    moving_ = 4;
    boxes_ = {{{0, 0}, {1, 1}}, {{5, 0}, {6, 1}}, no_box<2>(), {{0, 0}, {10, 10}}};
  }
  void advance() override {
    inserted_.clear();
    removed_.clear();
    moved_ = {{0}};
    boxes_[0] = {{0.5F * static_cast<Scalar>(++step_), 0}, {0.5F * static_cast<Scalar>(step_) + 1, 1}};
    const bool comes = step_ % 2 == 1;
    (comes ? inserted_ : removed_).push_back({2});
    boxes_[2] = comes ? Box<2>{{8, 8}, {9, 9}} : no_box<2>();
  }

 private:
  int step_ = 0;
};

TEST(SceneProperties, AreThoseOfTheMotion) {
  FourBoxes motion;
  PropertyMeter<2> meter;
  for (int step = 0; step < 5; ++step) {
    if (step > 0) motion.advance();
    meter.add(motion, 2);
  }
  const SceneProperties found = meter.properties();
  EXPECT_DOUBLE_EQ(found.objects, 17.0 / 5);
  EXPECT_DOUBLE_EQ(found.density, 10.0 / 17);
  EXPECT_DOUBLE_EQ(found.speed, 0.5);
  EXPECT_DOUBLE_EQ(found.decades, 1);
  EXPECT_DOUBLE_EQ(found.resting, 2.0 / 3) << "of the three that are there in two steps";
  EXPECT_DOUBLE_EQ(found.churn, 4.0 / 14);
}

/// It was "1e+02 % come and go".
TEST(SceneProperties, AreReadWithoutPowersOfTen) {
  const SceneProperties many{1000, 123.4, 250, 1, 0.5, 0.995};
  EXPECT_EQ(as_text(many),
            "1000 objects, 123 pairs an object, 250 sizes a step, sizes over 1.0 decades, 50 % at rest, "
            "100 % come and go in a step");
  const SceneProperties few{1000, 1.94, 0.031, 0.3, 0.12, 0.014};
  EXPECT_EQ(as_text(few),
            "1000 objects, 1.9 pairs an object, 0.031 sizes a step, sizes over 0.3 decades, 12 % at rest, "
            "1.4 % come and go in a step");
}

TEST(SceneProperties, SayNothingOfNothing) {
  const SceneProperties none = PropertyMeter<3>().properties();
  EXPECT_EQ(none.objects, 0);
  EXPECT_EQ(none.speed, 0);
  EXPECT_EQ(none.decades, 0);
}

}  // namespace
}  // namespace kerf

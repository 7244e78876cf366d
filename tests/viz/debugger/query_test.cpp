#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/dimensions.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/run_of.h"
#include "viz/gl/context.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

template <class T>
class DebuggerQuery : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  DebuggerQuery() {
    test::record_crowd<kDimension>(file_.path(), 60, test::busy_config());
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  /// Why the script ended early; empty if it did not.
  std::string play(const std::string& script) { return test::played(*debugger_, script); }

  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  test::TemporaryRecording file_;
  std::optional<Debugger> debugger_;
};
TYPED_TEST_SUITE(DebuggerQuery, test::Dimensions, test::DimensionNames);

TYPED_TEST(DebuggerQuery, IsAskedAtTheMouseAndStaysUntilItIsForgotten) {
  EXPECT_EQ(this->play(R"(
key End
expect query == none
hover view@0.5,0.5
wait 2
key Q
wait 2
expect query ~ visited
expect query ~ tested
key ,
wait 2
expect query ~ visited
click n0
wait 2
expect selection == n0
key Escape
wait 2
expect selection == nothing
expect query ~ visited
key Escape
wait 2
expect query == none
)"),
            "");
}

/// What is drawn is what the tree answers; the panel gives the reasons.
TYPED_TEST(DebuggerQuery, IsSearchedForDrawnAndExplained) {
  const std::string sphere = TypeParam::value == 2 ? "sphere 0,0,4" : "sphere 0,0,0,4";
  ASSERT_EQ(this->play("key End\nkey P\ntype \"" + sphere + "\"\nkey Enter\nwait 2\nexpect query ~ found"),
            "");
  DebuggerModel& model = this->debugger_->model();
  EXPECT_EQ(model.view.query, sphere);
  const std::string why = model.run().explain_query(sphere);
  EXPECT_THAT(why, HasSubstr(" of radius 4 overlaps "));
  EXPECT_EQ(this->play("hover \"panel why\"@0.5,0.5\nwait 2\nkey ctrl+C\nwait 2"), "");
  EXPECT_THAT(this->debugger_->take_copied().value_or(""), HasSubstr(" of radius 4 overlaps "));
}

TYPED_TEST(DebuggerQuery, WhatIsNoneIsRefusedWithItsForm) {
  EXPECT_EQ(this->play(R"(
key End
key P
type "ray 1,2"
key Enter
wait 2
expect query == none
expect message ~ "is not of the form OX,OY"
)"),
            "");
}

}  // namespace
}  // namespace kerf

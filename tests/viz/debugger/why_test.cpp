#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "viz/debugger/model/run.h"

namespace kerf {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What the panel *Why* says of a crowd in which operators act.
template <class T>
class Why : public testing::Test {
 protected:
  Why() {
    test::record_crowd<T::value>(file_.path(), 60, test::busy_config());
    run_ = open_run(file_.path());
  }

  test::TemporaryRecording file_;
  std::unique_ptr<kerf::Run> run_;
};
TYPED_TEST_SUITE(Why, test::Dimensions, test::DimensionNames);

TYPED_TEST(Why, AnObjectsPairsAreCountedAndNamed) {
  auto& run = *this->run_;
  run.go(Position::end_of(40));
  ASSERT_FALSE(run.pairs().empty());
  const Pair pair = run.pairs()[0];
  const auto count =
      std::ranges::count_if(run.pairs(), [&](const Pair& p) { return p.a == pair.a || p.b == pair.a; });
  EXPECT_THAT(run.explain(pair.a),
              HasSubstr("its pairs: " + std::to_string(count) + ", with " + std::to_string(pair.b.value)));
  for (ObjectId object{0}; object.value < run.objects(); ++object.value) {
    if (!run.has(object) ||
        std::ranges::any_of(run.pairs(), [&](const Pair& p) { return p.a == object || p.b == object; }))
      continue;
    EXPECT_THAT(run.explain(object), HasSubstr("its pairs: none\n"));
  }
}

TYPED_TEST(Why, WithinAStepAnObjectsPairsAreSaidToBeOfTheStepBefore) {
  auto& run = *this->run_;
  run.go(run.search(Expression::parse("op==split && kind==acted && step>20"), {}, true, {}).value());
  const std::uint32_t step = run.position().step;
  const Pair pair = run.pairs()[0];
  EXPECT_THAT(run.explain(pair.a), HasSubstr("its pairs of step " + std::to_string(step - 1) + ": "));
  run.go(Position::end_of(step));
  EXPECT_THAT(run.explain(pair.a), HasSubstr("its pairs: "));
}

/// In the middle of a step a node is explained as the view shows it, not as it is at the step's end.
TYPED_TEST(Why, ANodeIsExplainedAtThePresentMoment) {
  auto& run = *this->run_;
  run.go(run.search(Expression::parse("op==split && kind==acted"), {}, true, {}).value());
  const Position split = run.position();
  const NodeId node = run.event_node().value();
  EXPECT_THAT(run.explain(node), HasSubstr("after e" + std::to_string(split.event) + " of step " +
                                           std::to_string(split.step) + ", n0"));
  EXPECT_THAT(run.explain(node), HasSubstr(": partitioner "));
  run.go({split.step, split.event - 1});
  EXPECT_THAT(run.explain(node), HasSubstr(": leaf with "));
  EXPECT_THAT(run.explain(node), Not(HasSubstr("e" + std::to_string(split.event))));
  run.go(Position::end_of(split.step));
  EXPECT_THAT(run.explain(node), testing::StartsWith("after step " + std::to_string(split.step) + ", n0"));
}

}  // namespace
}  // namespace kerf

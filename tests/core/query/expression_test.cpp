#include "core/query/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/query/evaluate.h"
#include "core/trace/event.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// A moment of which the test says what is true.
class Given final : public Moment {
 public:
  std::map<Variable, double> numbers;
  std::map<Variable, GivenId> ids;
  std::vector<Happening> happening;

  [[nodiscard]] ConditionNumber number(Variable variable) const override {
    if (const auto id = ids.find(variable); id != ids.end()) return ConditionNumber::of(id->second);
    const auto found = numbers.find(variable);
    return found == numbers.end() ? ConditionNumber() : ConditionNumber::measured(found->second);
  }
  [[nodiscard]] ConditionNumber median(Variable variable) const override {
    return ConditionNumber::measured(number(variable).nearest / 4);
  }
  [[nodiscard]] bool happens(const ExpressionPart& part) const override {
    return part.a == GivenId::of(12) && std::ranges::find(happening, part.happening) != happening.end();
  }
};

bool is_true(std::string_view text, const Given& moment = {}) {
  return holds(Expression::parse(text), moment);
}

std::string refusal(std::string_view text) {
  try {
    (void)Expression::parse(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Expression, BindsAsInC) {
  EXPECT_TRUE(is_true("1 + 2 * 3 == 7"));
  EXPECT_TRUE(is_true("(1 + 2) * 3 == 9"));
  EXPECT_TRUE(is_true("10 - 3 - 2 == 5"));
  EXPECT_TRUE(is_true("8 / 4 / 2 == 1"));
  EXPECT_TRUE(is_true("-2 * -3 == 6"));
  EXPECT_TRUE(is_true("1 > 2 || 1 < 2 && 2 < 3"));
  EXPECT_FALSE(is_true("(1 > 2 || 1 < 2) && 2 > 3"));
  EXPECT_TRUE(is_true("!1 > 2"));
  EXPECT_FALSE(is_true("!(1 < 2)"));
  EXPECT_TRUE(is_true("!1>2 && 1<2"));
  for (const char* const text : {"1<=1", "1>=1", "1!=2", "1=1"}) EXPECT_TRUE(is_true(text)) << text;
  for (const char* const text : {"1<1", "1>1", "2<=1", "1>=2", "1!=1", "1==2"})
    EXPECT_FALSE(is_true(text)) << text;
}

TEST(Expression, NumbersHaveUnits) {
  EXPECT_TRUE(is_true("5ms == 0.005"));
  EXPECT_TRUE(is_true("20us > 0.000019 && 20us < 0.000021"));
  EXPECT_TRUE(is_true("2s == 2"));
  EXPECT_TRUE(is_true("5% == 0.05"));
  EXPECT_TRUE(is_true("1e3 == 1000"));
  EXPECT_THAT(refusal("step_time > 5h"), HasSubstr("known are s, ms, us and %"));
}

/// `pairs>5%` was taken as pairs > 0.05, and `step>1s` as step > 1.
TEST(Expression, AUnitThatTheQuantityDoesNotHaveIsRefused) {
  EXPECT_THAT(refusal("pairs>5%"), HasSubstr("does not fit: pairs has no unit\n  pairs>5%\n         ^"));
  EXPECT_THAT(refusal("step > 1s"), HasSubstr("does not fit: step has no unit"));
  EXPECT_THAT(refusal("5% < pairs + 1"), HasSubstr("fit: pairs + 1 has no unit\n  5% < pairs + 1\n   ^"));
  EXPECT_THAT(refusal("redundancy>5ms"), HasSubstr("redundancy takes % only"));
  EXPECT_THAT(refusal("step_time>5%"), HasSubstr("step_time takes s, ms and us only"));
  EXPECT_THAT(refusal("median(height) < 2us"), HasSubstr("median(height) has no unit"));
  EXPECT_THAT(refusal("1s > 5%"), HasSubstr("1s takes s, ms and us only"));
  for (const char* const text :
       {"median>5%", "median(pairs)>5ms", "(pairs)>5%", "pairs>-5%", "pairs>2*5%", "pairs+5%>1", "pairs-1s>1",
        "pairs>objects*1s", "op==split && step>1s", "!(depth<=8%)", "1/step_time>30%", "pairs/step_time>1s",
        "(1<2)==1s", "pair(1,2)==5%", "step_time*step_time>1s", "straddlers/population>1s", "node==17%",
        "entries/objects-1>1us", "redundancy*pairs>5%"})
    EXPECT_THAT(refusal(text), HasSubstr("this unit does not fit: ")) << text;
  EXPECT_THROW((void)Expression::parse_value("pairs+5%"), std::invalid_argument);
  for (const char* const text : {"redundancy>5%",
                                 "balance<=50%",
                                 "step_time>5ms",
                                 "step_time>2*median",
                                 "median<1s",
                                 "sweep_time>50%*step_time",
                                 "sweep_time/step_time>50%",
                                 "straddlers/population>5%",
                                 "pairs>5%*objects",
                                 "step_time/objects>2us",
                                 "step_time>2us*objects+1ms",
                                 "entries/objects-1>5%",
                                 "redundancy>1/objects",
                                 "1/step_time>30",
                                 "pairs>1e6*step_time",
                                 "median(redundancy)>5%",
                                 "-redundancy<-5%",
                                 "1s>5ms",
                                 "1s/step_time>30",
                                 "redundancy/2>5%",
                                 "step_time/2>5ms/3"})
    EXPECT_NO_THROW((void)Expression::parse(text)) << text;
}

/// `pairs>2*median` was taken as pairs > twice the seconds of a usual step: true of nearly every one.
TEST(Expression, AMedianWithoutAWordIsComparedWithTimesOnly) {
  EXPECT_THAT(refusal("pairs>2*median"),
              HasSubstr("median alone is that of step_time, but pairs has no unit; "
                        "write median(pairs)\n  pairs>2*median\n          ^"));
  EXPECT_THAT(refusal("step_time>1s || median < 1+redundancy/2 && pairs>1"),
              HasSubstr("1+redundancy/2 takes % only; write median(redundancy)"));
  EXPECT_THAT(refusal("pairs / median > 2"), HasSubstr("write median(pairs)"));
  EXPECT_THAT(refusal("pairs > 1ms+median"), HasSubstr("this unit does not fit: pairs has no unit"));
  EXPECT_THAT(refusal("pairs > median+1ms"), HasSubstr("write median(pairs)"));
  EXPECT_THAT(refusal("depth>median"), HasSubstr("write median(WORD)")) << "no word of steps";
  for (const char* const text : {"pairs-median>0", "pairs>median+1", "height>median/2", "median==leaves"})
    EXPECT_THAT(refusal(text), HasSubstr("median alone")) << text;
  for (const char* const text :
       {"pairs>2*median(pairs)", "pairs>1e6*median(step_time)", "sweep_time>median/2", "step_time/median>2",
        "1/median>30", "median>0.005", "median>5ms", "step_time-median>1ms", "median/objects>2us"})
    EXPECT_NO_THROW((void)Expression::parse(text)) << text;
}

/// `pairs-objects` was one word.
TEST(Expression, AMinusNeedsNoBlanks) {
  Given moment;
  moment.numbers = {{Variable::pairs, 9}, {Variable::objects, 5}, {Variable::op, 1}, {Variable::kind, 6}};
  EXPECT_TRUE(is_true("pairs-objects==4", moment));
  EXPECT_TRUE(is_true("pairs-objects-objects==-1", moment));
  EXPECT_TRUE(is_true("pairs-1==8", moment));
  EXPECT_TRUE(is_true("op==shift-split", moment));
  EXPECT_TRUE(is_true("kind==all-placed", moment));
  EXPECT_THAT(refusal("op==shift-slit"), HasSubstr("here one of these was expected"));
  EXPECT_THAT(refusal("pairs-object_s>3"), HasSubstr("'object_s' is not known"));
}

TEST(Expression, NamesStandForWhatTheMomentSays) {
  Given moment;
  moment.numbers = {{Variable::op, static_cast<double>(Operator::shift_split)},
                    {Variable::depth, 9},
                    {Variable::redundancy, 0.06},
                    {Variable::deferred, 17},
                    {Variable::step_time, 4}};
  EXPECT_TRUE(is_true("op==shift_split && depth>8", moment));
  EXPECT_TRUE(is_true("op==shift-split", moment));
  EXPECT_FALSE(is_true("op==merge", moment));
  EXPECT_TRUE(is_true("op!=merge", moment));
  EXPECT_TRUE(is_true("redundancy>0.05 && deferred>16", moment));
  EXPECT_TRUE(is_true("step_time>2*median", moment));
  EXPECT_TRUE(is_true("step_time==4*median(step_time)", moment));
  EXPECT_TRUE(is_true("redundancy==4*median(redundancy)", moment));
}

/// As doubles, ids beyond 2^53 met their neighbours.
TEST(Expression, IdsAreComparedWithAllTheirDigits) {
  Given moment;
  moment.ids = {{Variable::object, {false, 9007199254740993}}};
  moment.numbers = {{Variable::redundancy, 0.1}};
  for (const char* const text :
       {"object==9007199254740993", "object!=9007199254740992", "object>9007199254740992",
        "object<9007199254740994", "object<=9007199254740993", "object>=9007199254740993",
        "object-1==9007199254740992", "9007199254740992+1==object", "-object<-9007199254740992",
        "object==9007199254740993 && redundancy==0.1", "redundancy==10%", "redundancy==1/10",
        "object-9007199254740992>5*redundancy"})
    EXPECT_TRUE(is_true(text, moment)) << text;
  for (const char* const text :
       {"object==9007199254740992", "object==9007199254740994", "object!=9007199254740993",
        "object<=9007199254740992", "object>=9007199254740994", "object+1==9007199254740993"})
    EXPECT_FALSE(is_true(text, moment)) << text;
  moment.ids = {{Variable::object, {false, UINT64_MAX}}};
  EXPECT_TRUE(is_true("object==18446744073709551615 && object!=18446744073709551614", moment));
  moment.ids = {{Variable::object, {true, 9223372036854775807}}};
  EXPECT_TRUE(is_true("object==-9223372036854775807 && object>-9223372036854775808", moment));
}

TEST(Expression, AValueIsShownWithAllDigitsOfAnId) {
  Given moment;
  moment.ids = {{Variable::object, {false, UINT64_MAX}}, {Variable::step, {true, 12'345'678}}};
  moment.numbers = {{Variable::redundancy, 0.125}};
  const auto text = [&moment](const char* of) { return to_text(value(Expression::parse_value(of), moment)); };
  EXPECT_EQ(text("object"), "18446744073709551615");
  EXPECT_EQ(text("step"), "-12345678");
  EXPECT_EQ(text("redundancy"), "0.125");
  EXPECT_EQ(text("1/3"), "0.333333");
}

TEST(Expression, WhatDoesNotExistIsNeverTrue) {
  for (const char* const text :
       {"depth>8", "depth<=8", "depth==8", "depth!=8", "op==merge", "op!=merge", "depth+1>0"})
    EXPECT_FALSE(is_true(text)) << text;
  EXPECT_TRUE(is_true("!(depth>8)"));
}

TEST(Expression, ThingsHappenToPairsPlanesNodesAndObjects) {
  Given moment;
  moment.happening = {Happening::pair_enters, Happening::plane_moves};
  EXPECT_TRUE(is_true("pair(12,77) enters", moment));
  EXPECT_FALSE(is_true("pair(12,77) leaves", moment));
  EXPECT_FALSE(is_true("pair(12,77)", moment));
  EXPECT_TRUE(is_true("plane(n12) moves", moment));
  EXPECT_TRUE(is_true("plane(12) moves && !node(n12)", moment));
  EXPECT_FALSE(is_true("plane(n13) moves", moment));
  EXPECT_EQ(Expression::parse("pair(12,77) leaves").root().b, GivenId::of(77));
  EXPECT_EQ(Expression::parse("pair(-12034,18446744073709551615)").root().a, (GivenId{true, 12034}));
  EXPECT_EQ(Expression::parse("pair(-12034,18446744073709551615)").root().b, (GivenId{false, UINT64_MAX}));
}

TEST(Expression, KnowsWhatItNeeds) {
  EXPECT_FALSE(Expression::parse("redundancy>0.05").asks_events());
  EXPECT_TRUE(Expression::parse("redundancy>0.05 && op==merge").asks_events());
  EXPECT_TRUE(Expression::parse("object(3) moves").asks_events());
  EXPECT_FALSE(Expression::parse("pair(1,2)").asks_events());
  EXPECT_TRUE(Expression::parse("pair(1,2)").asks_pairs());
  EXPECT_TRUE(Expression::parse("missed>0").asks_oracle());
  EXPECT_FALSE(Expression::parse("placed>0").asks_oracle());
  EXPECT_TRUE(Expression::parse("depth>8").asks_depth());
}

/// It would mean (100<height)<200, which is always true.
TEST(Expression, AComparisonIsNotCompared) {
  for (const char* const text : {"100<height<200", "1<2==1", "1==1==1", "1!=2>0", "(1<2<3)", "!1<2<3"})
    EXPECT_THAT(refusal(text), HasSubstr("a comparison cannot be compared; write 100<height && height<200"))
        << text;
  EXPECT_THAT(refusal("100<height<200"), HasSubstr("\n  100<height<200\n            ^"));
  for (const char* const text : {"(1<2)==(3<4)", "(1>2)!=(3<4)", "1<2 && 2<3", "1+(2<3)==2"})
    EXPECT_TRUE(is_true(text)) << text;
}

TEST(Expression, NumbersAreNoConditions) {
  EXPECT_THAT(refusal("pairs"), HasSubstr("a number, not a condition"));
  EXPECT_THAT(refusal("!pairs"), HasSubstr("\n  !pairs\n   ^"));
  EXPECT_THAT(refusal("!(pairs+1)"), HasSubstr("a number, not a condition"));
  EXPECT_THAT(refusal("pairs+1 && height>1"), HasSubstr("\n  pairs+1 && height>1\n  ^"));
  EXPECT_THAT(refusal("height>1 && pairs+1"), HasSubstr("\n  height>1 && pairs+1\n              ^"));
  EXPECT_THAT(refusal("height>1 && height<9 || 1"), HasSubstr("|| 1\n                          ^"));
  for (const char* const text : {"!(pairs>0)", "!pair(1,2)", "pairs>0 && !(height==1 || pair(1,2) enters)"})
    EXPECT_NO_THROW((void)Expression::parse(text)) << text;
}

TEST(Expression, APairIsOfTwo) {
  EXPECT_THAT(refusal("pair(3,3)"), HasSubstr("no pair with itself"));
  EXPECT_THAT(refusal("pair(-3,-3) enters"), HasSubstr("no pair with itself"));
  EXPECT_NO_THROW((void)Expression::parse("pair(-3,3)"));
}

TEST(Expression, MistakesAreShownAtTheirPlace) {
  EXPECT_THAT(refusal("op==mrge"), HasSubstr("\n  op==mrge\n      ^"));
  EXPECT_THAT(refusal("op==mrge"), HasSubstr("balance, shift_split, split, swap, merge"));
  EXPECT_THAT(refusal("op>split"), HasSubstr("== or !="));
  EXPECT_THAT(refusal("dept>8"), HasSubstr("'dept' is not known"));
  EXPECT_THAT(refusal("dept>8"), HasSubstr("redundancy"));
  EXPECT_THAT(refusal("depth>"), HasSubstr("\n        ^"));
  EXPECT_THAT(refusal("depth>8)"), HasSubstr("an operator such as &&"));
  EXPECT_THAT(refusal("(depth>8"), HasSubstr("')' was expected"));
  EXPECT_THAT(refusal("pair(1) enters"), HasSubstr("',' was expected"));
  EXPECT_THAT(refusal("pair(a,b)"), HasSubstr("the number of an object, such as 17"));
  EXPECT_THAT(refusal("plane(n17)"), HasSubstr("moves was expected"));
  EXPECT_THAT(refusal("thing(17)"), HasSubstr("'thing' is not known"));
  EXPECT_THAT(refusal("depth+8"), HasSubstr("not a condition"));
  EXPECT_THAT(refusal("depth @ 8"), HasSubstr("means nothing here"));
  EXPECT_THAT(refusal("median(depth)>1"), HasSubstr("has a median"));
  EXPECT_THAT(refusal("pair(18446744073709551616,1)"), HasSubstr("the number of an object, such as 17"));
  EXPECT_THAT(refusal(""), HasSubstr("was expected"));
  EXPECT_THAT(refusal(std::string(5000, '(')), HasSubstr("nested too deeply"));
  EXPECT_THAT(refusal(std::string(5000, '!')), HasSubstr("nested too deeply"));
  std::string chain = "1";
  for (int k = 0; k < 4'000; ++k) chain += "+1";
  EXPECT_TRUE(is_true(chain + ">0")) << "long, but it fits";
  for (int k = 0; k < 200'000; ++k) chain += "+1";
  EXPECT_THAT(refusal(chain + ">0"), HasSubstr("too many"));
}

}  // namespace
}  // namespace kerf

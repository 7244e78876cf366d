#include "core/query/explain_query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/overloaded.h"
#include "core/replay/cursor.h"
#include "core/spatial/touch.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

template <class T>
class ExplainQuery : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  ExplainQuery() {
    test::record_crowd<kDimension>(file_.path(), 60, test::busy_config());
    recording_ = std::make_shared<RecordingReader<kDimension>>(file_.path());
  }

  test::TemporaryRecording file_;
  std::shared_ptr<RecordingReader<kDimension>> recording_;
};
TYPED_TEST_SUITE(ExplainQuery, test::Dimensions, test::DimensionNames);

/// Whether a query, but for the nearest, finds a box, by the definition.
template <int D>
bool is_found(const AskedQuery<D>& query, const Box<D>& box) {
  return std::visit(Overloaded{[&](const Ray<D>& ray) { return touches(Cast<D>(ray), box); },
                               [&](const Box<D>& asked) { return touches(asked, box); },
                               [&](const Sphere<D>& sphere) { return touches(sphere, box); },
                               [](const Nearest<D>&) { return false; }},
                    query);
}

/// Brute force finds the same, and no pruned node holds any of it, but for objects that are tested one by
/// one. (A ray is followed to its first hit only.)
template <int D>
void expect_right(const QueryExplanation<D>& answer, const BspState<D>& state) {
  std::vector<ObjectId> found;
  for (const FoundObject& one : answer.found) found.push_back(one.object);
  std::ranges::sort(found);
  std::vector<ObjectId> truth;
  for_each_placed(state.latest, [&](ObjectId object) {
    if (is_found<D>(answer.query, state.latest.box(object))) truth.push_back(object);
  });
  EXPECT_EQ(found, truth);
  if (answer.waiting > 0) return;
  for (const QueryVisit<D>& v : answer.visits) {
    if (v.visit.fate == NodeFate::visited) continue;
    const auto expect_absent = [&](ObjectId object) {
      const bool is_first = !answer.found.empty() && answer.found.front().object == object;
      const bool is_ray = answer.query.index() == static_cast<std::size_t>(QueryKind::ray);
      EXPECT_FALSE(is_ray ? is_first : std::ranges::binary_search(truth, object)) << object.value;
    };
    for_each_node(state.tree, v.visit.node, [&](NodeId node) {
      for (const Entry& entry : state.tree[node].entries) expect_absent(entry.object);
    });
  }
}

TYPED_TEST(ExplainQuery, FindsWhatBruteForceFindsAtEveryMoment) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  std::size_t found = 0;
  std::size_t pruned = 0;
  const std::string third = kD == 3 ? ",0" : "";
  for (int move = 0; move < 600; ++move) {
    if (!cursor.forward(Granularity::event)) break;
    for (const std::string& text :
         {"ray -3,0.5" + third + ",1,0.2" + third, "ray 1,-20" + third + ",0,1" + third,
          "box 0,0" + third + ",3,2" + (kD == 3 ? ",2" : ""), "sphere 2,1" + third + ",1.5",
          "sphere 1,1" + third + ",0"}) {
      const auto answer = explain_query(cursor.state().tree, cursor.state().latest, parse_query<kD>(text));
      ASSERT_EQ(answer.status, QueryStatus::ok) << text;
      expect_right<kD>(answer, cursor.state());
      found += answer.found.size();
      if (answer.waiting == 0) pruned += answer.pruned();
    }
  }
  EXPECT_GT(found, 100U);
  EXPECT_GT(pruned, 100U);
}

TYPED_TEST(ExplainQuery, OrdersTheNearestByTheirDistance) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(40);
  const auto answer = explain_query(cursor.state().tree, cursor.state().latest,
                                    parse_query<kD>(kD == 2 ? "nearest 1,1,5" : "nearest 1,1,0,5"));
  ASSERT_EQ(answer.found.size(), 5U);
  EXPECT_TRUE(std::ranges::is_sorted(answer.found, {}, &FoundObject::key));
  EXPECT_THAT(to_text(answer, {}), HasSubstr(" is nearest to "));
  EXPECT_THAT(to_text(answer, {}), HasSubstr(" away"));
}

TYPED_TEST(ExplainQuery, SaysWhyANodeIsPruned) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(40);
  const auto text_of = [&](const std::string& query) {
    return to_text(explain_query(cursor.state().tree, cursor.state().latest, parse_query<kD>(query)), {});
  };
  const std::string third = kD == 3 ? ",0" : "";
  EXPECT_THAT(text_of("ray 0,1e6" + third + ",1,0" + third), HasSubstr("pruned, y stays 1e+06, beside y ["));
  EXPECT_THAT(text_of("box 1e6,0" + third + ",2e6,1" + third), HasSubstr("] lies beside [1e+06, 2e+06]"));
  EXPECT_THAT(text_of("sphere 1e6,0" + third + ",1"), HasSubstr("pruned, its bounds are "));
  EXPECT_THAT(text_of("box 1,1" + third + ",0,0" + third), HasSubstr("cannot be asked"));
}

TYPED_TEST(ExplainQuery, SaysOfAPointInWhichBoxesItLies) {
  constexpr int kD = TypeParam::value;
  Cursor<kD> cursor(this->recording_);
  cursor.go_to_step(40);
  const auto answer = explain_query(cursor.state().tree, cursor.state().latest,
                                    parse_query<kD>(kD == 2 ? "sphere 1e6,0,0" : "sphere 1e6,0,0,0"));
  EXPECT_THAT(to_text(answer, {}), HasSubstr(" lies in 0 of " + std::to_string(answer.objects) + " boxes"));
  EXPECT_THAT(summary(answer), HasSubstr("point: 0 found"));
}

TEST(ParseQuery, ReadsEachKind) {
  EXPECT_EQ(to_text(parse_query<2>("ray 0,1.5, 1,-2")), "the ray from (0, 1.5) along (1, -2)");
  EXPECT_EQ(to_text(parse_query<3>(" box 0,0,0,1,2,3 ")), "the box from (0, 0, 0) to (1, 2, 3)");
  EXPECT_EQ(to_text(parse_query<2>("sphere 1,2,3")), "the sphere around (1, 2) of radius 3");
  EXPECT_EQ(to_text(parse_query<2>("sphere 1,2,0")), "the point (1, 2)");
  EXPECT_EQ(to_text(parse_query<3>("nearest 1,2,3,4")), "the point (1, 2, 3)");
}

TEST(ParseQuery, RefusesWhatIsNone) {
  for (const char* const text :
       {"", "ray", "ray 0,1,2", "ray 0,1,2,3,4", "ray 0,1,2,x", "ray 0,1,2,inf", "ray 0,1,2,nan",
        "ray 0,1,2,", "ray ,0,1,2", "ray 0 1 2 3", "beam 0,1,2,3", "box 0,0,1", "sphere 1,2", "nearest 1,2,0",
        "nearest 1,2,1.5", "nearest 1,2,-1", "nearest 1,2,1e9", "rays 0,1,2,3"})
    EXPECT_THROW((void)parse_query<2>(text), std::invalid_argument) << text;
  try {
    (void)parse_query<3>("ray 0,1,2,3");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("OX,OY,OZ,DX,DY,DZ, for example 0,1.5,2,1,0,0"));
  }
}

}  // namespace
}  // namespace kerf

#include "core/query/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/recorder.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two recordings with the same steps, of which more was said with each.
class CompareDeclared : public ::testing::Test {
 protected:
  /// What differs from a recording of which nothing was said.
  std::vector<std::string> said(const RecordingInfo& info, const RecordingInfo& other = basic()) {
    record("a.kerf", other);
    record("b.kerf", info);
    RecordingReader<2> a(folder_.path() / "a.kerf");
    RecordingReader<2> b(folder_.path() / "b.kerf");
    const RecordingComparison comparison = compare(a, b);
    EXPECT_FALSE(comparison.requests || comparison.events || comparison.pairs);
    EXPECT_EQ(comparison.same(), comparison.declared.empty());
    return comparison.declared;
  }
  [[nodiscard]] static RecordingInfo basic() {
    RecordingInfo info;
    info.dimension = 2;
    info.scene = "pile";
    return info;
  }
  [[nodiscard]] static RecordingInfo import() {
    RecordingInfo info = basic();
    info.imported = true;
    return info;
  }

 private:
  void record(const std::string& name, const RecordingInfo& info) const {
    std::filesystem::remove(folder_.path() / name);
    Bsp<2, EventLog> tree(info.config);
    Recorder<2> recorder(tree, folder_.path() / name, info);
    ASSERT_EQ(recorder.insert({0}, {{0, 0}, {1, 1}}, Mobility::moving), Status::ok);
    recorder.step();
    recorder.finish();
  }

  test::TemporaryFolder folder_;
};

TEST_F(CompareDeclared, NamesHowASceneRunsAgain) {
  EXPECT_THAT(said(basic()), IsEmpty());
  RecordingInfo info = basic();
  info.scene = "rods";
  info.seed = 7;
  info.objects = 60;
  info.grow = 30;
  info.recycle = 9;
  EXPECT_THAT(said(info), ElementsAre("scene: pile in A, rods in B", "seed: 1 in A, 7 in B",
                                      "objects: the scene's own in A, 60 in B",
                                      "steps of growth: the scene's own in A, 30 in B",
                                      "steps between objects that fall anew: 0 in A, 9 in B"));
}

/// The scene of an import is the name of a file, which may be another one.
TEST_F(CompareDeclared, FilesOfImportsMayHaveOtherNames) {
  RecordingInfo info = import();
  info.scene = "again.csv";
  EXPECT_THAT(said(info, import()), IsEmpty());
}

TEST_F(CompareDeclared, NamesDecisions) {
  RecordingInfo info = basic();
  info.decisions = {{1'000'000, Operator::split, {}}};
  EXPECT_THAT(said(info), ElementsAre("decisions: none in A, e1000000 refused in B"));
  RecordingInfo other = info;
  other.decisions.push_back({2'000'000, Operator::split, ChosenPlane{3, 0.25F}});
  EXPECT_THAT(said(other, info),
              ElementsAre("decisions: no other in A, e2000000 takes direction 3 at 0.25 in B"));
}

/// A plane of all boxes decides nothing, walls with the same text may be apart.
TEST_F(CompareDeclared, NamesTheAxesAlongWhichAllBoxesAreFlat) {
  RecordingInfo a = import();
  a.design.rounding = {.digits = 6};
  RecordingInfo b = a;
  EXPECT_THAT(said(b, a), IsEmpty());
  b.design.rounding.planes = 0b110;
  EXPECT_THAT(said(b, a),
              ElementsAre("rounding of boxes: to 6 digits in A, to 6 digits with all boxes flat along "
                          "y and z in B"));
}

/// They decide what is a fault of a structure.
TEST_F(CompareDeclared, NamesHowTheNumbersOfAStructureWereWritten) {
  RecordingInfo a = import();
  RecordingInfo b = a;
  a.digits = TheirDigits{{3, 0}, {6, 3}};
  b.digits = TheirDigits{{3, 0, true}, {6, 3}};
  EXPECT_THAT(said(a, a), IsEmpty());
  EXPECT_THAT(
      said(b, a),
      ElementsAre("digits of a structure: 3 digits with 0 decimals of boxes and 6 digits with 3 decimals "
                  "of nodes in A, 3 digits with 0 decimals, too few, of boxes and 6 digits with 3 "
                  "decimals of nodes in B"));
  EXPECT_THAT(said(b, import()).at(0), ::testing::StartsWith("digits of a structure: not known in A, "));
}

}  // namespace
}  // namespace kerf

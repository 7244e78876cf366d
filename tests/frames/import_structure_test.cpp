// `kerf import --structure`: bugs planted in a tree like Bullet's are found and named from its nodes alone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "tests/frames/import_program.h"
#include "tests/support/boxes.h"
#include "tests/support/planted_box_tree.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// What an engine with such a tree writes of two steps: of thirteen objects one flies to another one far
/// away, and its pairs are those of the tree with itself.
class ImportStructure : public test::ImportProgram {
 protected:
  static constexpr std::uint32_t kFar = 12;  // where object 3 goes

  struct Files {
    std::string boxes;
    std::string nodes;
    std::string pairs;
  };

  /// `claims`: the margin that the engine says it leaves.
  Files run(TreeBug bug, bool moves = true, const std::string& claims = "") const {
    std::ostringstream boxes("step,object,min_x,max_x,min_y,max_y\n", std::ios::ate);
    std::ostringstream nodes("step,node,parent,min_x,max_x,min_y,max_y,object,margin\n", std::ios::ate);
    std::ostringstream pairs("step,a,b\n", std::ios::ate);
    PlantedBoxTree tree(bug);
    std::vector<Box<2>> objects;
    Random random(5);
    for (std::uint32_t id = 0; id < kFar; ++id) objects.push_back(test::random_box<2>(random, 10, 0.5));
    objects.push_back(test::box_at<2>({{20.6F, 20}}, 0.5F));
    tree.insert({kFar}, objects.back());  // first, so that its leaf lies beside all others
    for (std::uint32_t id = 0; id < kFar; ++id) tree.insert({id}, objects[id]);
    for (std::uint32_t id = 0; id <= kFar; ++id) put_box(1, id, objects[id], boxes);
    put_tree(1, tree, claims, nodes, objects, pairs);
    objects[3] = test::box_at<2>({{20, 20}}, 0.5F);
    if (moves) tree.move({3}, objects[3]);
    put_box(2, 3, objects[3], boxes);
    put_tree(2, tree, claims, nodes, objects, pairs);
    return {write("boxes.csv", boxes.str()), write("nodes.csv", nodes.str()),
            write("pairs.csv", pairs.str())};
  }
  [[nodiscard]] std::string import_of(const Files& files) const {
    return imported("a", files.boxes, {"--pairs", files.pairs, "--structure", files.nodes});
  }
  [[nodiscard]] RunOutcome lint(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"lint", path("a.kerf"), "--structure"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kerf(arguments);
  }

 private:
  static void put_box(int step, std::uint32_t id, const Box<2>& box, std::ostream& out) {
    out << step << ',' << id << ',' << box.min[0] << ',' << box.max[0] << ',' << box.min[1] << ','
        << box.max[1] << '\n';
  }

  static void put_tree(int step, const PlantedBoxTree& tree, const std::string& claims, std::ostream& nodes,
                       const std::vector<Box<2>>& objects, std::ostream& pairs) {
    nodes.precision(9);
    StructureParts<2> parts;
    tree.describe(parts);
    std::vector<std::string> members(parts.cells.size());
    for (const CellMember& member : parts.members)
      members[member.cell] += (members[member.cell].empty() ? "" : " ") + std::to_string(member.object.value);
    for (std::size_t k = 0; k < parts.cells.size(); ++k) {
      const StructureCell<2>& cell = parts.cells[k];
      const std::string parent = cell.parent == kNoPart ? "" : std::to_string(parts.cells[cell.parent].name);
      nodes << step << ',' << cell.name << ',' << parent << ',' << cell.box.min[0] << ',' << cell.box.max[0]
            << ',' << cell.box.min[1] << ',' << cell.box.max[1] << ',' << members[k] << ','
            << (members[k].empty() ? "" : claims) << '\n';
    }
    for (const CellMember& a : parts.members)
      for (const CellMember& b : parts.members)
        if (a.object < b.object && meet(parts, a.cell, b.cell) &&
            overlaps(objects[a.object.index()], objects[b.object.index()]))
          pairs << step << ',' << a.object.value << ',' << b.object.value << '\n';
  }

  /// Whether each search finds the other leaf, as Bullet's walk through both trees at once has to.
  static bool meet(const StructureParts<2>& parts, std::uint32_t a, std::uint32_t b) {
    const auto finds = [&](std::uint32_t from, std::uint32_t to) {
      for (; to != kNoPart; to = parts.cells[to].parent)
        if (!overlaps(parts.cells[from].box, parts.cells[to].box)) return false;
      return true;
    };
    return finds(a, b) && finds(b, a);
  }
};

TEST_F(ImportStructure, ASoundTreeHasNoFault) {
  const std::string out = import_of(run(TreeBug::none, true, "0.25"));
  EXPECT_THAT(out, HasSubstr(": 0 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("its structure has 50 nodes in 2 steps: 0 faults\n"));
  const RunOutcome outcome = lint({"--depth", "12", "--overlap", "90%", "--margin", "0.2"});
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  EXPECT_EQ(outcome.out, "the structure is sound in the 2 of 2 steps in which it is known\n");
  EXPECT_EQ(run_kerf({"verify", path("a.kerf")}).exit, 0);
  EXPECT_THAT(explained("a", "2", "3,12"), HasSubstr("finds it"));
}

TEST_F(ImportStructure, ARefitThatWasForgottenIsNamedAndEndsTheSearch) {
  const std::string out = import_of(run(TreeBug::refit_forgotten));
  EXPECT_THAT(out, HasSubstr("1 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("1 fault in 1 step"));
  EXPECT_THAT(out, HasSubstr("first in step 2: child outside its parent: n"));
  const RunOutcome outcome = lint();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, StartsWith("step 2: child outside its parent: n"));
  EXPECT_THAT(outcome.out, HasSubstr("along x it ends at 20.75, beyond "));
  const std::string why = explained("a", "2", "3,12");
  EXPECT_THAT(why, HasSubstr("the other engine missed it"));
  EXPECT_THAT(why, HasSubstr("for object 3 ends at n"));
  EXPECT_THAT(why, HasSubstr("A refit was forgotten"));
  EXPECT_THAT(explained("a", "1", "3,12"), Not(HasSubstr("fault")));
}

TEST_F(ImportStructure, ANodeThatWasNotPutInAgainIsLost) {
  const std::string out = import_of(run(TreeBug::not_reinserted));
  EXPECT_THAT(out, HasSubstr("1 missed, 0 extra"));
  EXPECT_THAT(lint().out, HasSubstr("step 2: object in no cell: object 3 is in no cell\n"));
  EXPECT_THAT(explained("a", "2", "3,12"),
              HasSubstr("object 3 is in no node: its leaf is lost, or was not put in again"));
}

TEST_F(ImportStructure, AnObjectThatHasLeftItsLeafIsNamed) {
  static_cast<void>(import_of(run(TreeBug::none, false)));
  EXPECT_THAT(lint().out, StartsWith("step 2: object outside its cell: object 3 lies outside its cell n"));
  EXPECT_THAT(explained("a", "2", "3,12"), HasSubstr("the fault: object 3 lies outside its node n"));
}

TEST_F(ImportStructure, AMarginOfZeroIsNamedIfOneWasClaimedOrIsWanted) {
  const Files files = run(TreeBug::no_margin);
  EXPECT_THAT(import_of(files), HasSubstr("0 faults"));
  EXPECT_EQ(lint().exit, 0);
  EXPECT_THAT(lint({"--margin", "0.1"}).out, HasSubstr(" along x, less than 0.1\n"));
  EXPECT_THAT(import_of(run(TreeBug::no_margin, true, "0.25")), HasSubstr("1 fault in 1 step"))
      << "only one leaf was placed anew";
  EXPECT_THAT(lint().out, StartsWith("step 2: no margin: n"));
  EXPECT_THAT(lint().out, HasSubstr(" leaves object 3 a margin of 0 along x, less than 0.25\n"));
}

TEST_F(ImportStructure, ANodeBelowTwoIsNamed) {
  static_cast<void>(import_of(run(TreeBug::child_of_two)));
  EXPECT_THAT(lint().out, HasSubstr("child of two nodes: n"));
  EXPECT_THAT(lint().out, HasSubstr("object in no cell: object "));
}

TEST_F(ImportStructure, TwoImportsAreComparedByTheirStructures) {
  (void)import_of(run(TreeBug::none, false));
  std::filesystem::rename(path("a.kerf"), path("sound.kerf"));
  (void)import_of(run(TreeBug::none, false));
  EXPECT_EQ(run_kerf({"compare", path("a.kerf"), path("sound.kerf")}).exit, 0);
  const Files other = run(TreeBug::none, false, "0.25");
  (void)imported("other", other.boxes, {"--pairs", other.pairs, "--structure", other.nodes});
  (void)imported("none", other.boxes, {"--pairs", other.pairs});
  for (const std::string name : {"other", "none"}) {
    const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path(name + ".kerf")});
    EXPECT_EQ(compared.exit, 1) << name;
    EXPECT_THAT(compared.out, HasSubstr("structures differ first in step 1\n"));
  }
}

/// A step whose nodes were taken out of the file is no step without nodes.
TEST_F(ImportStructure, AStepThatWasTakenAwayIsRefused) {
  for (const char* const taken : {" WHERE step = 2", ""}) {
    (void)import_of(run(TreeBug::none));
    test::change_recording(path("a.kerf"), std::string("DELETE FROM their_structures") + taken);
    const RunOutcome outcome = lint();
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("has of another engine is not what was written"));
  }
}

TEST_F(ImportStructure, LimitsThatAreNoneAreRefused) {
  static_cast<void>(import_of(run(TreeBug::none)));
  EXPECT_THAT(lint({"--depth", "x"}).err,
              HasSubstr("--depth 'x' is not a whole number from 0 to 4294967295"));
  EXPECT_THAT(lint({"--overlap", "x%"}).err, HasSubstr("--overlap 'x%' is no share"));
  EXPECT_THAT(lint({"--overlap", "50"}).err, HasSubstr("do you mean '50%'?"));
  EXPECT_THAT(lint({"--margin", "-1"}).err, HasSubstr("--margin '-1' is no length"));
  EXPECT_EQ(run_kerf({"lint", path("a.kerf"), "--depth", "3"}).exit, 2);
  EXPECT_THAT(imported("b", path("boxes.csv")), Not(HasSubstr("structure")));
  EXPECT_THAT(run_kerf({"lint", path("b.kerf"), "--structure"}).err,
              HasSubstr("has no structure of another engine"));
}

/// Objects and steps have the engine's names, nodes as well; several objects may share a node.
TEST_F(ImportStructure, EverythingKeepsItsName) {
  const std::string boxes = write("boxes.csv",
                                  "step,object,min_x,max_x,min_y,max_y\n5000,-7,0,1,0,1\n"
                                  "5000,900000000000,3,4,0,1\n5001,-7,0,1,0,1\n");
  const std::string nodes = write("nodes.csv",
                                  "frame,parentId,nodeId,Body,lower x,upper x,lower y,upper y,isLeaf\n"
                                  "5001,-1,140737488355328,-7 900000000000,0,3.5,0,1,0\n");
  EXPECT_THAT(imported("a", boxes, {"--structure", nodes}), HasSubstr("first in step 5001: object outside"));
  EXPECT_EQ(lint().out,
            "step 5001: object outside its cell: object 900000000000 lies outside its cell n140737488355328: "
            "along x it ends at 4, beyond 3.5\n");
}

TEST_F(ImportStructure, BadFilesAreRefusedWithTheirLines) {
  const std::string boxes = write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n");
  const std::string heading = "step,node,parent,min_x,max_x,min_y,max_y,object,leaf,margin\n";
  const auto error = [&](const std::string& text) {
    return refused(boxes, {"--structure", write("nodes.csv", text)});
  };
  EXPECT_THAT(error("1,0,,0,1,0,1,0\n"), HasSubstr("nodes.csv needs a heading: step,node,parent"));
  EXPECT_THAT(error("step,node,min_x,max_x,min_y,max_y,object\n1,0,0,1,0,1,0\n"),
              HasSubstr("the heading must be step,node,parent"));
  EXPECT_THAT(error(heading + "1,0,,0,1,0,1,0,1,0\n1,x,,0,1,0,1,0,1,0\n"), HasSubstr("line 3"));
  EXPECT_THAT(error(heading + "1,,,0,1,0,1,0,1,0\n"), HasSubstr("line 2: the node is blank"));
  EXPECT_THAT(error(heading + "1,0,,0,,0,1,0,1,0\n"), HasSubstr("line 2: node 0 lacks a bound"));
  EXPECT_THAT(error(heading + "1,0,,0,nan,0,1,0,1,0\n"), HasSubstr("is no number"));
  EXPECT_THAT(error(heading + "1,0,,0,1,0,1,0 y,1,0\n"), HasSubstr("is neither an object nor several"));
  EXPECT_THAT(error(heading + "1,0,,0,1,0,1,0,2,0\n"), HasSubstr("line 2"));
  EXPECT_THAT(error(heading + "1,0,,0,1,0,1,0,1,-3\n"), HasSubstr("is no length"));
  EXPECT_THAT(error(heading + "1,0,,0,1,0,1,0,1,1e39\n"), HasSubstr("is no length")) << "as a float";
  EXPECT_THAT(error(heading + "1,-1,,0,1,0,1,0,1,0\n"),
              HasSubstr("line 2: '-1' in column 2, node, is no name"));
  EXPECT_THAT(error("step,node,parent,min_x,max_x,min_y,max_y,min_z,max_z,object\n1,0,,0,1,0,1,0,1,0\n"),
              HasSubstr("its boxes have a z"));
  EXPECT_THAT(error(heading + "7,0,,0,1,0,1,0,1,0\n"),
              HasSubstr("nodes.csv, line 2: step 7 has neither boxes nor pairs"));
  EXPECT_THAT(refused(boxes, {"--structure", path("none.csv")}), HasSubstr("none.csv"));
  EXPECT_THAT(refused(boxes, {"--structure", path("nodes.csv"), "--unite"}),
              HasSubstr("an object of several boxes has several nodes"));
}

/// Null pointers and indices are no parents, and -1 is no object.
TEST_F(ImportStructure, WhatIsNullIsNone) {
  const std::string boxes = write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n");
  const auto said = [&](const std::string& lines) {
    const std::string heading = "step,node,parent,min_x,max_x,min_y,max_y,object\n";
    return imported("a", boxes, {"--structure", write("nodes.csv", heading + lines)});
  };
  for (const std::string null : {"0", "4294967295", "18446744073709551615"})
    EXPECT_THAT(said("1,4," + null + ",0,1,0,1,-1\n1,5,4,0,1,0,1,0\n"),
                HasSubstr("2 nodes in 1 step: 0 faults"));
  EXPECT_THAT(said("1,4,,0,1,0,1,\n1,5,0,0,1,0,1,0\n"), HasSubstr("n5 is lost: its parent n0 is no node"))
      << "roots are blank here";
  EXPECT_THAT(said("1,4,7,0,1,0,1,0\n"), HasSubstr("n4 is lost: its parent n7 is no node"));
}

TEST_F(ImportStructure, ALineWithOnlyAStepIsAnEmptyTree) {
  const std::string boxes =
      write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n2,0,0,1,0,1\n3,0,0,1,0,1\n");
  const std::string heading = "step,node,parent,min_x,max_x,min_y,max_y,object\n";
  const std::string nodes = write("nodes.csv", heading + "1,4,,0,1,0,1,0\n2,,,,,,,\n");
  const std::string out = imported("a", boxes, {"--structure", nodes});
  EXPECT_THAT(out, HasSubstr("1 node in 2 steps: 1 fault in 1 step"));
  EXPECT_THAT(out, HasSubstr("first in step 2: object in no cell: object 0 is in no cell"));
  EXPECT_EQ(lint().out, "step 2: object in no cell: object 0 is in no cell\n");
  EXPECT_THAT(imported("a", boxes, {"--structure", write("nodes.csv", heading)}),
              HasSubstr("its structure has 0 nodes in 0 steps\n"));
  EXPECT_THAT(imported("a", boxes, {"--structure", write("nodes.csv", heading + "2,4,,0,1,0,1,0\n")}),
              HasSubstr("1 node in 1 step: 0 faults"));
  EXPECT_EQ(lint().out, "the structure is sound in the 1 of 3 steps in which it is known\n");
}

/// That a tree holds fixed objects is known from the first step in which it does.
TEST_F(ImportStructure, AFixedObjectThatATreeHasLostIsMissed) {
  const std::string boxes = write("boxes.csv",
                                  "step,object,min_x,max_x,min_y,max_y,fixed\n1,0,0,1,0,1,0\n1,1,5,6,0,1,1\n"
                                  "2,0,0,1,0,1,0\n3,0,0,1,0,1,0\n");
  const std::string nodes = write("nodes.csv",
                                  "step,node,parent,min_x,max_x,min_y,max_y,object\n1,4,,0,6,0,1,0 1\n"
                                  "2,4,,0,1,0,1,0\n3,4,,0,1,0,1,0\n");
  EXPECT_THAT(imported("a", boxes, {"--structure", nodes}), HasSubstr("2 faults in 2 steps"));
  EXPECT_EQ(lint().out, "step 2: object in no cell: object 1 is in no cell; until step 3, in 2 steps\n");
}

/// How the numbers were written says what they may be off by.
TEST_F(ImportStructure, BoundsMayBeOffByTheDigitsThatWereNotWritten) {
  const auto said = [&](const std::string& object, const std::string& node) {
    return imported(
        "a", write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0," + object + ",0,1\n"),
        {"--structure",
         write("nodes.csv", "step,node,parent,min_x,max_x,min_y,max_y,object\n1,4,," + node + ",0,1,0\n")});
  };
  EXPECT_THAT(said("100000.0,100000.4", "99999.0,99999.5"), HasSubstr("1 fault in 1 step"))
      << "it lies outside as a whole, by less than a 100,000th of where it is";
  EXPECT_THAT(said("0.000000,0.000013", "0,1.26e-05"), HasSubstr(": 0 faults")) << "%f and %g";
  EXPECT_THAT(said("0.000000,0.000014", "0,1.26e-05"), HasSubstr("1 fault in 1 step"));
  EXPECT_THAT(said("99999.6,100001", "99999.6,100000.625"), HasSubstr(": 0 faults")) << "%g and %.9g";
  EXPECT_THAT(said("99999.6,100002", "99999.6,100000.625"), HasSubstr("1 fault in 1 step"));
  EXPECT_THAT(said("0.5,1.6", "0.527,1.601"), HasSubstr(": 0 faults")) << "%.1f and %.3f";
  EXPECT_THAT(said("0.4,1.6", "0.527,1.601"), HasSubstr("1 fault in 1 step"));
  EXPECT_THAT(said("0.5,1.5", "0.527,1.601"), HasSubstr("1 fault in 1 step")) << "halves are exact";
  EXPECT_THAT(said("0.3,1.6", "0.4,1.6"), HasSubstr("1 fault in 1 step")) << "one decimal each";
}

/// An object that the boxes do not have is a fault of the structure, not of the file.
TEST_F(ImportStructure, AnObjectThatIsNoneIsNamed) {
  const std::string boxes = write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n");
  const std::string nodes =
      write("nodes.csv", "step,node,parent,min_x,max_x,min_y,max_y,object\n1,4,,0,1,0,1,0 5\n");
  EXPECT_THAT(imported("a", boxes, {"--structure", nodes}),
              HasSubstr("unknown object: n4 holds object 5, which is no object"));
}

}  // namespace
}  // namespace kerf::test

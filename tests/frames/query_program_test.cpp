#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "core/recording/recording_reader.h"
#include "core/replay/replayer.h"
#include "tests/frames/program.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// A recording of 60 steps in which operators act.
class QueryProgram : public ::testing::Test {
 protected:
  QueryProgram() { record("a", "min_threshold=4,max_threshold=8,schedule_interval=2"); }

  void record(const std::string& name, const std::string& config) {
    const RunOutcome outcome = run_kerf({"record", "pile", "-o", file(name), "--steps", "60", "--objects",
                                         "60", "--grow", "30", "--config", config});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.path() / (name + ".kerf"); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] Pair pair_that_comes_and_goes() const {
    const auto recording = std::make_shared<RecordingReader<2>>(file("a"));
    Replayer<2> replayer(recording);
    const auto at = [&](std::uint32_t step) {
      replayer.seek(step);
      std::vector<Pair> pairs(replayer.tree().pairs().begin(), replayer.tree().pairs().end());
      std::ranges::sort(pairs);
      return pairs;
    };
    const std::vector<Pair> last = at(60);
    for (std::uint32_t step = 2; step < 60; ++step)
      for (const Pair& pair : at(step))
        if (!std::ranges::binary_search(at(1), pair) && !std::ranges::binary_search(last, pair)) return pair;
    ADD_FAILURE() << "there is none";
    return {};
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(QueryProgram, StepsToWhereAConditionHolds) {
  const RunOutcome forward = run_kerf({"step", file("a"), "--to", "op==split && kind==acted"});
  ASSERT_EQ(forward.exit, 0) << forward.err;
  EXPECT_THAT(forward.out, ::testing::ContainsRegex("^e[0-9]+ step [0-9]+ split n"));
  EXPECT_THAT(forward.out, HasSubstr("state hash "));
  const RunOutcome three = run_kerf({"step", file("a"), "--to", "op==split && kind==acted", "--hits", "3"});
  EXPECT_TRUE(three.out.starts_with(forward.out));
  EXPECT_EQ(std::ranges::count(three.out, '\n'), 9);
  const std::string last_line = three.out.substr(three.out.rfind("\ne") + 1);
  const std::string last = last_line.substr(0, last_line.find(' '));
  const RunOutcome back = run_kerf(
      {"step", file("a"), "--to", "op==split && kind==acted", "--from", last, "--reverse", "--hits", "2"});
  EXPECT_THAT(back.out, ::testing::EndsWith(forward.out));  // the first is the second before the third
}

TEST_F(QueryProgram, SaysWhenThereIsNoSuchMomentAndWhatIsWrongWithACondition) {
  const RunOutcome none = run_kerf({"step", file("a"), "--to", "missed>0"});
  EXPECT_EQ(none.exit, 1);
  EXPECT_THAT(none.err, HasSubstr("there is no such moment"));
  const RunOutcome wrong = run_kerf({"step", file("a"), "--to", "redundncy>0.05"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_THAT(wrong.err, HasSubstr("'redundncy' is not known"));
  EXPECT_EQ(run_kerf({"step", file("a"), "--to", "step>3", "--from", "61"}).exit, 2);
  EXPECT_EQ(run_kerf({"step", file("a"), "--to", "step>3", "--hits", "0"}).exit, 2);
  EXPECT_THAT(run_kerf({"step", file("a"), "--to", "step<3", "--hits", "9"}).err,
              HasSubstr("there are 2 moments and no more, of the 9 that were asked for"));
  EXPECT_EQ(run_kerf({"step", file("a"), "--to", "step<3", "--hits", "2"}).err, "");
  EXPECT_EQ(run_kerf({"step", file("b"), "--to", "step>3"}).exit, 2);
}

TEST_F(QueryProgram, ExplainsPairsNodesAndEvents) {
  RecordingReader<2> recording(file("a"));
  const RunOutcome node = run_kerf({"explain", file("a"), "--step", "50", "--node", "n0"});
  EXPECT_EQ(node.exit, 0) << node.err;
  EXPECT_THAT(node.out, HasSubstr("after step 50, n0"));
  const std::vector<OperatorRow> rows = recording.operators();
  const auto first = std::ranges::find(rows, NodeId{0}, [](const OperatorRow& row) { return row.node.node; });
  ASSERT_NE(first, rows.end());
  const RunOutcome event = run_kerf({"explain", file("a"), "--event", "e" + std::to_string(first->event)});
  EXPECT_EQ(event.exit, 0) << event.err;
  EXPECT_THAT(event.out, HasSubstr("n0 was a leaf that is crowded"));
  const RunOutcome pair = run_kerf({"explain", file("a"), "--pair", "5,9"});
  EXPECT_EQ(pair.exit, 0) << pair.err;
  EXPECT_THAT(pair.out, HasSubstr("after step 60, 5 and 9 are"));
  EXPECT_EQ(run_kerf({"explain", file("a"), "--pair", "5,5"}).exit, 2);
  EXPECT_EQ(run_kerf({"explain", file("a"), "--pair", "5"}).exit, 2);
  EXPECT_EQ(run_kerf({"explain", file("a")}).exit, 2);
  EXPECT_EQ(run_kerf({"explain", file("a"), "--event", "e99999999"}).exit, 2);
  EXPECT_EQ(run_kerf({"explain", file("a"), "--step", "99", "--node", "1"}).exit, 2);
}

TEST_F(QueryProgram, ExplainsQueries) {
  const RunOutcome hits = run_kerf({"explain", file("a"), "--step", "50", "--ray=-100,-100,1,1"});
  EXPECT_EQ(hits.exit, 0) << hits.err;
  EXPECT_THAT(hits.out, HasSubstr("after step 50, the ray from (-100, -100) along (1, 1) hits"));
  EXPECT_THAT(hits.out, HasSubstr("  n0, "));
  const RunOutcome misses = run_kerf({"explain", file("a"), "--ray", "0,1e6,1,0"});
  EXPECT_THAT(misses.out, HasSubstr("hits 0 of"));
  EXPECT_THAT(misses.out, HasSubstr("pruned, y stays 1e+06, beside y ["));
  EXPECT_THAT(run_kerf({"explain", file("a"), "--box", "-100,-100,100,100"}).out,
              HasSubstr("the box from (-100, -100) to (100, 100) overlaps "));
  EXPECT_THAT(run_kerf({"explain", file("a"), "--sphere", "0,1,2"}).out, HasSubstr(" of radius 2 overlaps "));
  EXPECT_THAT(run_kerf({"explain", file("a"), "--nearest", "0,1,3"}).out, HasSubstr(" is nearest to "));
  EXPECT_EQ(run_kerf({"explain", file("a"), "--nearest", "0,1,3", "--box", "0,0,1,1"}).exit, 2);
  for (const auto& [option, numbers] : {std::pair{"--box", "2,2,0,0"}, {"--sphere", "0,1,-1"}}) {
    const RunOutcome refused = run_kerf({"explain", file("a"), option, numbers});
    EXPECT_EQ(refused.exit, 2) << refused.out;
    EXPECT_THAT(refused.err,
                HasSubstr("cannot be asked, it is not-ordered: a box has its lower corner first"));
  }
  for (const char* wrong : {"1", "1,2,3", "1,2,3,4,5", "1,2,3,x", "1,2,3,inf", "1,2,3,4,"})
    EXPECT_THAT(run_kerf({"explain", file("a"), "--ray", wrong}).err,
                HasSubstr("is not of the form OX,OY,DX,DY"))
        << wrong;
}

TEST_F(QueryProgram, ComparesRuns) {
  record("same", "min_threshold=4,max_threshold=8,schedule_interval=2");
  record("other", "min_threshold=4,max_threshold=8,schedule_interval=2,min_balance=0.3");
  EXPECT_EQ(run_kerf({"compare", file("a"), file("same")}).exit, 0);
  const RunOutcome differs = run_kerf({"compare", file("a"), file("other"), "--json"});
  EXPECT_EQ(differs.exit, 1);
  const auto json = nlohmann::json::parse(differs.out);
  EXPECT_FALSE(json["same"]);
  EXPECT_TRUE(
      json["first_different"]["requests"].is_null());  // exact pairs lead to the same run of the scene
  EXPECT_TRUE(json["first_different"]["pairs"].is_null());
  EXPECT_GT(json["first_different"]["events"], 0);
  EXPECT_THAT(run_kerf({"compare", file("a"), file("other")}).out,
              HasSubstr("events     differ first in step"));
}

/// They were called the same, though one of them, or both, may have gone on.
TEST_F(QueryProgram, ComparesWhetherRunsWereEndedInOrder) {
  const auto unfinished_copy = [&](const std::string& name) {
    std::filesystem::copy_file(file("a"), file(name));
    test::change_recording(file(name), "UPDATE meta SET value='0' WHERE key='complete'");
    test::change_recording(file(name), "DELETE FROM meta WHERE key='end'");
  };
  unfinished_copy("killed");
  unfinished_copy("too");
  const RunOutcome one = run_kerf({"compare", file("a"), file("killed")});
  EXPECT_EQ(one.exit, 1);
  EXPECT_THAT(one.out, HasSubstr("\nended      in order: yes in A, no in B\n"));
  const auto json = nlohmann::json::parse(run_kerf({"compare", file("killed"), file("a"), "--json"}).out);
  EXPECT_FALSE(json["same"]);
  EXPECT_EQ(json["a"]["ended_in_order"], false);
  EXPECT_EQ(json["b"]["ended_in_order"], true);
  EXPECT_EQ(json["not_compared"], "");
  const RunOutcome both = run_kerf({"compare", file("killed"), file("too")});
  EXPECT_EQ(both.exit, 0);
  EXPECT_THAT(both.out,
              HasSubstr("\nnot compared: what came after step 60 of either, since neither was ended"));
  const auto open = nlohmann::json::parse(run_kerf({"compare", file("killed"), file("too"), "--json"}).out);
  EXPECT_TRUE(open["same"]);
  EXPECT_EQ(open["not_compared"], "what came after step 60 of either");
}

/// The same boxes with another rule: other operators, the same pairs. With the same rule: the same run.
TEST_F(QueryProgram, RunsAgainWithAnotherConfiguration) {
  ASSERT_EQ(run_kerf({"rerun", file("a"), "-o", file("b"), "--config", "min_balance=0.3"}).exit, 0);
  ASSERT_EQ(run_kerf({"rerun", file("a"), "-o", file("c")}).exit, 0);
  EXPECT_EQ(run_kerf({"compare", file("a"), file("c")}).exit, 0);
  const auto json = nlohmann::json::parse(run_kerf({"compare", file("a"), file("b"), "--json"}).out);
  EXPECT_TRUE(json["first_different"]["requests"].is_null());
  EXPECT_TRUE(json["first_different"]["pairs"].is_null());
  EXPECT_FALSE(json["first_different"]["events"].is_null());
  EXPECT_EQ(run_kerf({"verify", file("b")}).exit, 0);
  EXPECT_EQ(run_kerf({"rerun", file("a"), "-o", file("a"), "--overwrite"}).exit, 2);
  EXPECT_EQ(run_kerf({"rerun", file("a"), "-o", file("d"), "--config", "min_balnce=0.3"}).exit, 2);
}

/// A parameter that changes nothing else is another run nevertheless: 5 % instead of 2.5 % may matter later.
TEST_F(QueryProgram, AnotherConfigurationIsAnotherRun) {
  ASSERT_EQ(run_kerf({"rerun", file("a"), "-o", file("b"), "--config", "max_height=60", "--from", "9"}).exit,
            0);
  const RunOutcome compared = run_kerf({"compare", file("a"), file("b")});
  EXPECT_EQ(compared.exit, 1);
  EXPECT_THAT(compared.out, HasSubstr("configs    differ first in step 9\n"));
  const auto json = nlohmann::json::parse(run_kerf({"compare", file("a"), file("b"), "--json"}).out);
  EXPECT_FALSE(json["same"]);
  EXPECT_EQ(json["first_different"]["config"], 9);
  EXPECT_TRUE(json["first_different"]["events"].is_null());
}

TEST_F(QueryProgram, AnOracleThatWasNotAskedHasFoundNothing) {
  const std::string out = run_kerf({"verify", file("a"), "--oracle-every", "1000"}).out;
  EXPECT_THAT(out, HasSubstr("oracle: asked in no step\n"));
  EXPECT_THAT(out, ::testing::Not(HasSubstr("0 missed")));
}

/// What if this split had not been, had taken another plane, or the rule had changed from here on?
TEST_F(QueryProgram, RunsAgainWithADecision) {
  const RunOutcome found = run_kerf({"step", file("a"), "--to", "op==split && kind==acted"});
  const std::string event = found.out.substr(0, found.out.find(' '));
  ASSERT_EQ(run_kerf({"rerun", file("a"), "-o", file("b"), "--refuse", event}).exit, 0);
  EXPECT_EQ(run_kerf({"verify", file("b")}).exit, 0);
  EXPECT_THAT(run_kerf({"step", file("b"), "--to", "op==split && kind==refused"}).out,
              HasSubstr("refused by a decision"));
  const auto json = nlohmann::json::parse(run_kerf({"compare", file("a"), file("b"), "--json"}).out);
  EXPECT_THAT(found.out, HasSubstr(" step " + json["first_different"]["events"].dump() + " "));
  EXPECT_TRUE(json["first_different"]["pairs"].is_null());

  const RunOutcome taken = run_kerf({"rerun", file("a"), "-o", file("c"), "--take", event + ":1"});
  ASSERT_EQ(taken.exit, 0) << taken.err;
  EXPECT_EQ(run_kerf({"verify", file("c")}).exit, 0);
  ASSERT_EQ(run_kerf({"rerun", file("c"), "-o", file("d"), "--config", "merge=0", "--from", "40"}).exit, 0);
  EXPECT_EQ(run_kerf({"verify", file("d")}).exit, 0);
}

TEST_F(QueryProgram, SaysWhyADecisionCannotBe) {
  const auto error = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"rerun", file("a"), "-o", file("b")});
    const RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_FALSE(std::filesystem::exists(file("b")));
    return outcome.err;
  };
  EXPECT_THAT(error({"--refuse", "e0"}), HasSubstr("not an operator that acts"));
  EXPECT_THAT(error({"--refuse", "12"}), HasSubstr("is not an event such as e1234"));
  EXPECT_THAT(error({"--take", "e12"}), HasSubstr("is not an event with a candidate"));
  EXPECT_THAT(error({"--from", "7"}), HasSubstr("--from says where --config begins"));
  EXPECT_THAT(error({"--config", "merge=0", "--from", "61"}), HasSubstr("goes from step 1 to 60"));
}

TEST_F(QueryProgram, ExportsATimelineAndTables) {
  const RunOutcome trace = run_kerf({"export", file("a"), "--chrome-trace", "-o", path("trace.json")});
  ASSERT_EQ(trace.exit, 0) << trace.err;
  const auto json = test::read_json(path("trace.json"));
  std::map<std::string, int> kinds;
  for (const auto& event : json["traceEvents"]) ++kinds[event["ph"]];
  EXPECT_EQ(kinds["X"], 60 * 6);
  EXPECT_EQ(kinds["C"], 60 * 4);
  EXPECT_GT(kinds["i"], 5);
  const RunOutcome csv = run_kerf({"export", file("a"), "--csv"});
  EXPECT_EQ(std::ranges::count(csv.out, '\n'), 61);
  EXPECT_EQ(run_kerf({"export", file("a")}).exit, 2);
  EXPECT_EQ(run_kerf({"export", file("a"), "--csv", "-o", path("no/such.csv")}).exit, 2);
}

/// Its own boxes, exported and imported, make the same run.
TEST_F(QueryProgram, WhatIsExportedCanBeImported) {
  ASSERT_EQ(run_kerf({"export", file("a"), "--boxes", "-o", path("boxes.csv")}).exit, 0);
  const RunOutcome imported =
      run_kerf({"import", path("boxes.csv"), "-o", file("b"), "--config",
                "free_directions=0,min_threshold=4,max_threshold=8,schedule_interval=2"});
  ASSERT_EQ(imported.exit, 0) << imported.err;
  const RecordingReader<2> a(file("a"));
  const RecordingReader<2> b(file("b"));
  ASSERT_EQ(a.steps(), b.steps());
  for (std::uint32_t step = 1; step <= a.steps(); ++step)
    ASSERT_EQ(a.row(step).pairs_hash, b.row(step).pairs_hash);
  EXPECT_TRUE(b.info().imported);
}

TEST_F(QueryProgram, TheirMissedExtraAndRepeatedPairsAreFound) {
  std::ofstream(path("boxes.csv")) << "step,object,min_x,max_x,min_y,max_y\n"
                                      "10,0,0,1,0,1\n10,1,1,2,0,1\n10,2,5,6,5,6\n"
                                      "11,2,0.5,1.5,0.5,1.5\n"
                                      "13,1,,,,\n";
  std::ofstream(path("pairs.csv")) << "10,0,1\n"
                                      "11,1,0\n11,0,1\n11,1,2\n"  // twice, and 0-2 is missed
                                      "12,0,1\n12,0,2\n12,1,2\n"
                                      "13,0,2\n13,1,2\n";  // 1 is gone
  const RunOutcome imported =
      run_kerf({"import", path("boxes.csv"), "--pairs", path("pairs.csv"), "-o", file("b")});
  ASSERT_EQ(imported.exit, 0) << imported.err;
  EXPECT_THAT(imported.out, HasSubstr("9 pairs: 1 missed, 1 extra, 1 twice"));
  EXPECT_THAT(imported.out, HasSubstr("first wrong in step 11"));
  EXPECT_THAT(run_kerf({"step", file("b"), "--to", "missed>0"}).out, ::testing::StartsWith("step 11\n"));
  EXPECT_THAT(run_kerf({"step", file("b"), "--to", "extra>0"}).out, ::testing::StartsWith("step 13\n"));
  const RunOutcome verified = run_kerf({"verify", file("b")});
  EXPECT_EQ(verified.exit, 0) << verified.err;
  EXPECT_THAT(verified.out, HasSubstr("theirs: 9 pairs, 1 missed, 1 extra, 1 twice"));
  const RunOutcome why = run_kerf({"explain", file("b"), "--step", "11", "--pair", "0,2"});
  EXPECT_THAT(why.out, HasSubstr("0 and 2 are a pair: their boxes overlap"));
  EXPECT_THAT(why.out, HasSubstr("the other engine missed it"));
}

/// Boxes without a line stay as they are, also when pairs go on for longer.
TEST_F(QueryProgram, TheirPairsAreJudgedToTheirLastStep) {
  std::ofstream(path("boxes.csv")) << "10,0,0,1,0,1\n10,1,1,2,0,1\n";
  std::ofstream(path("pairs.csv")) << "10,0,1\n13,0,1\n";
  const RunOutcome imported =
      run_kerf({"import", path("boxes.csv"), "--pairs", path("pairs.csv"), "-o", file("b")});
  ASSERT_EQ(imported.exit, 0) << imported.err;
  EXPECT_THAT(imported.out, HasSubstr("2 steps numbered 10 to 13"));
  EXPECT_THAT(imported.out, HasSubstr("2 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(imported.out, HasSubstr("odd: 1 step with pairs and without a line of boxes"));
  std::ofstream(path("pairs.csv")) << "10,0,1\n9,0,1\n";
  const RunOutcome early =
      run_kerf({"import", path("boxes.csv"), "--pairs", path("pairs.csv"), "-o", file("c")});
  EXPECT_EQ(early.exit, 2);
  EXPECT_THAT(early.err, HasSubstr("pairs.csv, line 2"));
  EXPECT_THAT(early.err, HasSubstr("step 10"));
}

TEST_F(QueryProgram, MistakesInAnImportAreNamedByTheirLine) {
  const auto refusal = [&](const std::string& text) {
    std::ofstream(path("boxes.csv")) << text;
    const RunOutcome outcome = run_kerf({"import", path("boxes.csv"), "-o", file("b"), "--overwrite"});
    EXPECT_EQ(outcome.exit, 2) << text;
    return outcome.err;
  };
  EXPECT_THAT(refusal("1,0,0,1,0,1\n1,0,0,1\n"), HasSubstr("boxes.csv, line 2"));
  EXPECT_THAT(refusal("2,0,0,1,0,1\n1,0,0,1,0,1\n"), HasSubstr("step 1 comes after step 2"));
  EXPECT_THAT(refusal("1,0,0,one,0,1\n"), HasSubstr("'one' in column 4"));
  EXPECT_THAT(refusal("1,a,0,1,0,1\n"), HasSubstr("no whole number of 64 bits"));
  EXPECT_THAT(refusal("1,0\n"), HasSubstr("6 columns in 2D and 8 in 3D"));
  EXPECT_THAT(refusal("1,0,,,,\n"), HasSubstr("goes, but is not there"));
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("has no boxes"));
  EXPECT_EQ(run_kerf({"import", path("none.csv"), "-o", file("c")}).exit, 2);
}

TEST_F(QueryProgram, MinimizesToARecordingAPictureAndATest) {
  const RunOutcome outcome =
      run_kerf({"minimize", file("a"), "--when", "op==split && kind==acted", "-o", file("small")});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const RecordingReader<2> whole(file("a"));
  const RecordingReader<2> small(file("small"));
  EXPECT_LT(small.steps(), 5U);
  EXPECT_LT(small.rows().back().statistics.objects, whole.rows().back().statistics.objects);
  EXPECT_EQ(run_kerf({"verify", file("small")}).exit, 0);
  EXPECT_EQ(run_kerf({"step", file("small"), "--to", "op==split && kind==acted"}).exit, 0);
  EXPECT_GT(std::filesystem::file_size(path("small.png")), 1000U);
  const std::string test = test::read_text(path("small.cpp"));
  EXPECT_THAT(test, HasSubstr("op==split && kind==acted"));
  EXPECT_THAT(test,
              HasSubstr("EXPECT_EQ(tree.state_hash(), 0x" + to_hex(small.rows().back().state_hash) + "U);"));
  EXPECT_EQ(run_kerf({"minimize", file("a"), "--when", "missed>0", "-o", file("none")}).exit, 1);
  const RunOutcome timed =
      run_kerf({"minimize", file("a"), "--when", "step_time>2*median", "-o", file("none")});
  EXPECT_EQ(timed.exit, 2);
  EXPECT_THAT(timed.err, HasSubstr("times differ from run to run"));
}

/// Without the objects it names, a condition does not hold; of the whole recording it is refused.
TEST_F(QueryProgram, MinimizesToTheObjectsThatAConditionNames) {
  const auto [a, b] = pair_that_comes_and_goes();
  const std::string names = std::to_string(a.value) + "," + std::to_string(b.value);
  for (const std::string& when :
       {"pair(" + names + ")", "pair(" + names + ") enters", "pair(" + names + ") leaves",
        "object(" + std::to_string(a.value) + ") moves"}) {
    const RunOutcome outcome =
        run_kerf({"minimize", file("a"), "--when", when, "-o", file("small"), "--overwrite"});
    ASSERT_EQ(outcome.exit, 0) << when << outcome.err;
    EXPECT_EQ(run_kerf({"step", file("small"), "--to", when}).exit, 0) << when;
    EXPECT_LE(RecordingReader<2>(file("small")).rows().back().statistics.objects, 2U) << when;
  }
  EXPECT_THAT(run_kerf({"minimize", file("a"), "--when", "pair(0,99999)", "-o", file("none")}).err,
              HasSubstr("has no object 99999"));
}

TEST_F(QueryProgram, DrawsTheMomentThatItFinds) {
  const RunOutcome outcome = run_kerf({"step", file("a"), "--to", "step==40", "--picture", path("40.png")});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_GT(std::filesystem::file_size(path("40.png")), 1000U);
  const RunOutcome fewer =
      run_kerf({"step", file("a"), "--to", "step>=40", "--hits", "50", "--picture", path("last.png")});
  EXPECT_EQ(fewer.exit, 0) << fewer.err;
  ASSERT_TRUE(std::filesystem::exists(path("last.png")));
  ASSERT_EQ(run_kerf({"step", file("a"), "--to", "step==60", "--picture", path("60.png")}).exit, 0);
  EXPECT_TRUE(test::read_text(path("last.png")) == test::read_text(path("60.png")));
}

}  // namespace
}  // namespace kerf::test

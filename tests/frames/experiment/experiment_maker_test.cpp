// The runs of an experiment and the processes that make them.
#include "frames/experiment/experiment_maker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "frames/support/version.h"
#include "tests/frames/program.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

double processor_seconds(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

ExperimentPlan small_plan() { return {.size = {.steps = 100, .objects = 300}, .seeds = 1}; }

/// So that none of them finds what another one has left in memory.
TEST(ExperimentMaker, EachRunIsMadeByAnotherProcess) {
  const TemporaryFolder folder;
  ExperimentMaker maker(folder.path(), small_plan(), Shard{}, Replace::nothing);
  const double ours = processor_seconds(RUSAGE_SELF);
  const double theirs = processor_seconds(RUSAGE_CHILDREN);
  maker.make([] { return false; });
  EXPECT_EQ(maker.made(), 4U);
  EXPECT_GT(processor_seconds(RUSAGE_CHILDREN) - theirs, 4 * (processor_seconds(RUSAGE_SELF) - ours));
  std::size_t runs = 0;
  maker.for_each([&](const RunId& run, const ExperimentRun& steps) {
    EXPECT_EQ(run.simulation, runs++);
    EXPECT_EQ(steps.size(), 100U);
  });
  EXPECT_EQ(runs, 4U);
}

/// A shard has as many runs as another, or one more.
TEST(ExperimentMaker, ShardsAreAlikeInSize) {
  const TemporaryFolder folder;
  const ExperimentPlan plan{.size = {.steps = 50, .objects = 50}, .seeds = 3, .repeats = 5};
  for (std::uint32_t index = 0; index < 7; ++index) {
    const std::size_t runs =
        ExperimentMaker(folder.path(), plan, Shard{index, 7}, Replace::nothing).missing();
    EXPECT_TRUE(runs == 8 || runs == 9) << runs;
  }
}

/// Repeats of a seed have the same objects, pairs and contacts, whatever they take: another kerf may have had
/// others.
TEST(ExperimentMaker, RepeatsThatCountOtherPairsAreRefused) {
  const TemporaryFolder folder;
  const ExperimentPlan plan{.size = {.steps = 50, .objects = 50}, .seeds = 1, .repeats = 2};
  const auto save = [&](const RunId& run, std::uint32_t moving, std::uint64_t pairs, std::uint64_t contacts) {
    ExperimentRun steps;
    for (std::uint32_t step = 1; step <= 50; ++step)
      steps.push_back(
          {step, moving, pairs, contacts, 0.5, std::vector<ContestantStep>(lineup_of(run).names.size())});
    std::filesystem::remove(run_path(folder.path(), run));
    save_run(folder.path(), run, steps);
  };
  for (std::size_t simulation = 0; simulation < 4; ++simulation)
    for (const std::uint32_t repeat : {1U, 2U})
      save({RunKind::paper, simulation, plan.size, repeat}, 3, 7, 1);
  const ExperimentMaker maker(folder.path(), plan, Shard{}, Replace::nothing);
  std::size_t runs = 0;
  const auto count = [&](const RunId&, const ExperimentRun&) { ++runs; };
  maker.for_each(count);
  EXPECT_EQ(runs, 8U);
  const auto refusal = [&]() -> std::string {
    try {
      maker.for_each(count);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "it was read";
  };
  const auto is_refused = HasSubstr("simulation-3-fracture-seed-1-repeat-2.csv has other pairs");
  const RunId again{RunKind::paper, 2, plan.size, 2};
  save(again, 3, 8, 1);
  EXPECT_THAT(refusal(), is_refused) << "other pairs";
  save(again, 4, 7, 1);
  EXPECT_THAT(refusal(), is_refused) << "other objects";
  save(again, 3, 7, 2);
  EXPECT_THAT(refusal(), is_refused) << "other contacts";
  save(again, 3, 7, 1);
  EXPECT_EQ(refusal(), "it was read");
}

/// As a file of which a part was pasted from elsewhere, or one of another kerf.
class ExperimentRunFile : public testing::Test {
 protected:
  ExperimentRunFile() {
    for (std::uint32_t step = 1; step <= 50; ++step)
      steps_.push_back({step, 3, 2, 1, 0.5, std::vector<ContestantStep>(lineup_of(run_).names.size())});
    save_run(folder_.path(), run_, steps_);
    text_ = test::read_text(run_path(folder_.path(), run_));
  }
  [[nodiscard]] std::string refusal(const std::string& from, const std::string& to) {
    std::string text = text_;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    std::ofstream(run_path(folder_.path(), run_)) << text;
    try {
      (void)load_run(folder_.path(), run_, false);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "it was read";
  }

  RunId run_{.size = {.steps = 50, .objects = 50}};
  ExperimentRun steps_;
  TemporaryFolder folder_;
  std::string text_;
};

TEST_F(ExperimentRunFile, ComesBack) {
  const auto found = load_run(folder_.path(), run_, false);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 50U);
  EXPECT_EQ(found->back().rest, 0.5);
}

TEST_F(ExperimentRunFile, LinesThatAreNotItsOwnAreRefused) {
  EXPECT_THAT(refusal("\n7,3,", "\n8,3,"), HasSubstr("is damaged; remove it"));
  EXPECT_THAT(refusal("\n7,3,", "\n0,3,"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal("\n7,3,", "\n7,-3,"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal("\n7,3,", "\n7,3x,"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal(",0,1,0.5\n", ",0,1,nan\n"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal(",0,1,0.5\n", ",0,1,-0.5\n"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal("candidates,collision_ms", "collision_ms,candidates"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal("# kerf experiment 5", "# kerf experiment 4"), HasSubstr("of another build of kerf"));
  EXPECT_THAT(refusal(text_, ""), HasSubstr("is empty; remove it"));
}

/// Runs of two builds were samples of one experiment, without a word.
TEST_F(ExperimentRunFile, ThatOfAnotherBuildIsRefused) {
  const std::string build = ", build " + build_id() + "\n";
  EXPECT_THAT(refusal(build, ", build 0123456789abcdef\n"),
              HasSubstr("of another build of kerf; choose another folder"));
  EXPECT_THAT(refusal(build, "\n"), HasSubstr("of another build of kerf"));
  EXPECT_FALSE(load_run(folder_.path(), run_, true)) << "--overwrite makes it anew";
  EXPECT_EQ(refusal(build, build), "it was read");
}

TEST_F(ExperimentRunFile, ALineOfAnotherBroadPhaseIsRefused) {
  EXPECT_THAT(refusal("\n7,3,ode-quadtree,", "\n7,3,ode-hash,"), HasSubstr("is damaged; remove it"));
  EXPECT_THAT(refusal("\n7,3,kerf-paper,", "\n7,3,kerf-papers,"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal("\n7,3,kerf-paper,", "\n7,3,,"), HasSubstr("is damaged"));
}

TEST_F(ExperimentRunFile, ALineOfOtherColumnsIsRefused) {
  EXPECT_THAT(refusal(",0,1,0.5\n", ",0,1,0.5,0\n"), HasSubstr("is damaged; remove it"));
  EXPECT_THAT(refusal(",0,1,0.5\n", ",0,1,0.5,\n"), HasSubstr("is damaged"));
  EXPECT_THAT(refusal(",0,1,0.5\n", ",0,1\n"), HasSubstr("is damaged"));
}

/// As a copy that was stopped leaves it. No line that is left is wrong.
TEST_F(ExperimentRunFile, OneThatEndsEarlyIsRefused) {
  const std::string last_step = text_.substr(text_.find("\n50,3,") + 1);
  EXPECT_THAT(refusal(last_step, ""), HasSubstr("is damaged; remove it")) << "it lacks a step";
  const std::string last_line = text_.substr(text_.rfind("\n50,3,") + 1);
  ASSERT_LT(last_line.size(), last_step.size());
  EXPECT_THAT(refusal(last_line, ""), HasSubstr("is damaged; remove it"))
      << "its last step lacks a broad phase";
}

TEST(ExperimentMaker, WhatIsStoppedIsSaid) {
  const TemporaryFolder folder;
  ExperimentPlan plan = small_plan();
  plan.size.steps = 100'000;
  ExperimentMaker maker(folder.path(), plan, Shard{}, Replace::nothing);
  try {
    maker.make([] { return true; });
    FAIL() << "it went on";
  } catch (const Interrupted& interrupted) {
    EXPECT_THAT(interrupted.what(), HasSubstr("0 of 4 runs are in"));
  }
  EXPECT_TRUE(folder.files().empty());
}

/// The folder is gone when the first run is to be saved.
TEST(ExperimentMaker, ARunThatFailsIsNamedWithItsReason) {
  const TemporaryFolder folder;
  const std::filesystem::path gone = folder.path() / "gone";
  ExperimentMaker maker(gone, small_plan(), Shard{}, Replace::nothing);
  std::filesystem::remove_all(gone);
  try {
    maker.make([] { return false; });
    FAIL() << "it was saved";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("simulation 1 (terrain), seed 1, repeat 1: cannot write "));
    EXPECT_THAT(error.what(), HasSubstr(gone.string()));
  }
}

}  // namespace
}  // namespace kerf::test

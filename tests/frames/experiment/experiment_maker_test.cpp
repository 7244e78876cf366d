// The runs of an experiment and the processes that make them.
#include "frames/experiment/experiment_maker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <stdexcept>

#include "frames/support/errors.h"
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

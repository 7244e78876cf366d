#include "frames/support/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

namespace kerf {
namespace {

TEST(Interrupt, OneWithinAnotherChangesNothing) {
  const InterruptGuard outer;
  {
    const InterruptGuard inner;
    EXPECT_FALSE(inner.requested());
    (void)std::raise(SIGINT);
    EXPECT_TRUE(inner.requested());
  }
  EXPECT_TRUE(outer.requested());
  const InterruptGuard later;
  EXPECT_TRUE(later.requested()) << "what was requested is not forgotten";
}

TEST(Interrupt, TheEndOfOneWithinAnotherLeavesTheOtherOnGuard) {
  const InterruptGuard outer;
  { const InterruptGuard inner; }
  (void)std::raise(SIGINT);
  EXPECT_TRUE(outer.requested());
}

TEST(Interrupt, TheNextOneBeginsAnew) {
  {
    const InterruptGuard first;
    (void)std::raise(SIGTERM);
    EXPECT_TRUE(first.requested());
  }
  const InterruptGuard second;
  EXPECT_FALSE(second.requested());
  (void)std::raise(SIGINT);
  EXPECT_TRUE(second.requested());
}

/// SIGPIPE was what a program begins with, though the parent had it ignored.
TEST(Interrupt, SignalsDoAfterwardsWhatTheyDidBefore) {
  const auto before_pipe = std::signal(SIGPIPE, SIG_IGN);
  const auto own = [](int) {};
  const auto before_terminate = std::signal(SIGTERM, own);
  { const InterruptGuard guard; }
  EXPECT_EQ(std::signal(SIGPIPE, before_pipe), SIG_IGN);
  EXPECT_EQ(std::signal(SIGTERM, before_terminate), +own);
}

TEST(InterruptDeathTest, OutsideOfAGuardItEndsTheProgramWithTheCode) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto interrupted = [signal](bool guarded) {
      exit_when_interrupted(130);
      if (guarded) {
        const InterruptGuard guard;
      }
      (void)std::raise(signal);
    };
    EXPECT_EXIT(interrupted(false), testing::ExitedWithCode(130), "kerf: interrupted");
    EXPECT_EXIT(interrupted(true), testing::ExitedWithCode(130), "kerf: interrupted");
  }
}

}  // namespace
}  // namespace kerf

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

}  // namespace
}  // namespace kerf

#include "core/base/poll.h"

#include <gtest/gtest.h>

#include <thread>

namespace kerf {
namespace {

TEST(Poll, AsksWhatWasMadeLastAsLongAsItLives) {
  int outer = 0;
  int inner = 0;
  poll();
  const Polling first([&] { ++outer; });
  poll();
  {
    const Polling second([&] { ++inner; });
    poll();
  }
  poll();
  EXPECT_EQ(outer, 2);
  EXPECT_EQ(inner, 1);
}

TEST(Poll, WorkOfAnotherThreadIsNotGivenUp) {
  const Polling polling([] { throw Stopped(); });
  std::thread([] { EXPECT_NO_THROW(poll()); }).join();
  EXPECT_THROW(poll(), Stopped);
}

}  // namespace
}  // namespace kerf

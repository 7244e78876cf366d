#include "frames/frame_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kerf {
namespace {

FrameJob job(std::uint32_t step) {
  FrameJob made;
  made.record.step = step;
  return made;
}

TEST(FrameQueue, FinishesEveryFrameInOrder) {
  std::vector<std::uint32_t> finished;
  FrameQueue queue(3, [&](FrameJob& done) { finished.push_back(done.record.step); });
  for (std::uint32_t step = 0; step < 100; ++step) queue.add(job(step));
  queue.finish();
  ASSERT_EQ(finished.size(), 100U);
  for (std::uint32_t step = 0; step < 100; ++step) EXPECT_EQ(finished[step], step);
}

TEST(FrameQueue, ErrorComesOutOfFinish) {
  FrameQueue queue(3, [](FrameJob&) { throw std::runtime_error("disk full"); });
  queue.add(job(0));
  EXPECT_THROW(queue.finish(), std::runtime_error);
}

TEST(FrameQueue, ErrorComesOutOfAddAndStopsTheRest) {
  int finished = 0;
  FrameQueue queue(2, [&](FrameJob&) {
    ++finished;
    throw std::runtime_error("disk full");
  });
  EXPECT_THROW(
      {
        for (std::uint32_t step = 0; step < 100; ++step) queue.add(job(step));
      },
      std::runtime_error);
  EXPECT_EQ(finished, 1);
}

TEST(FrameQueue, HoldsNoMoreThanItsCapacity) {
  std::atomic<bool> open = false;
  std::atomic<int> added = 0;
  FrameQueue queue(2, [&](FrameJob&) {
    while (!open) std::this_thread::yield();
  });
  std::thread producer([&] {
    for (std::uint32_t step = 0; step < 10; ++step) {
      queue.add(job(step));
      ++added;
    }
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_LE(added, 3) << "one at work, two waiting";
  open = true;
  producer.join();
  queue.finish();
  EXPECT_EQ(added, 10);
}

TEST(FrameQueue, CanBeLeftUnfinished) {
  FrameQueue queue(4, [](FrameJob&) {});
  queue.add(job(0));
}

}  // namespace
}  // namespace kerf

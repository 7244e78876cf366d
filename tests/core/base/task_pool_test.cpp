#include "core/base/task_pool.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/hard/flush_to_zero.h"

namespace kerf::test {
namespace {

TEST(TaskPool, DoesEachPieceOnceWhateverTheNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    TaskPool pool(threads);
    std::vector<std::atomic<int>> done(1000);
    std::atomic<bool> known = true;
    pool.for_each(done.size(), [&](std::size_t piece, std::size_t thread) {
      ++done[piece];
      if (thread >= threads) known = false;
    });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    EXPECT_TRUE(known) << "a thread had a number beyond " << threads;
  }
}

/// What the host's own work by oneTBB may use, also where it has raised that.
TEST(TaskPool, OthersKeepTheirThreads) {
  const auto allowed = [] {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  };
  const auto processors = static_cast<unsigned>(tbb::info::default_concurrency());
  const tbb::global_control raised(tbb::global_control::max_allowed_parallelism, processors + 4);
  const std::size_t before = allowed();
  for (const unsigned threads : {2U, processors, processors + 1}) {
    TaskPool pool(threads);
    EXPECT_EQ(allowed(), before) << threads;
    std::atomic<std::size_t> least = before;
    pool.for_each(64, [&](std::size_t, std::size_t) { least = std::min(least.load(), allowed()); });
    EXPECT_EQ(least, before) << threads;
    EXPECT_EQ(allowed(), before) << threads;
  }
}

TEST(TaskPool, PiecesTakeDenormalsAsTheirCallerDoes) {
  TaskPool pool(2);
  const auto are_kept = [&pool] {
    std::atomic<int> kept = 0;
    pool.for_each(64, [&](std::size_t, std::size_t) {
      const volatile float denormal = std::numeric_limits<float>::denorm_min();
      kept += denormal > 0 ? 1 : 0;
    });
    return kept.load();
  };
  EXPECT_EQ(are_kept(), 64);
  const FlushToZero flush(true);
  const volatile float denormal = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(are_kept(), denormal > 0 ? 64 : 0) << "where the processor can take them for zero, all pieces do";
}

/// Whether both of two pieces meet the other within a second: in one thread the first would wait in vain.
bool two_meet(TaskPool& pool) {
  std::mutex mutex;
  std::condition_variable both;
  int here = 0;
  int met = 0;
  pool.for_each(2, [&](std::size_t, std::size_t) {
    std::unique_lock lock(mutex);
    ++here;
    both.notify_all();
    met += both.wait_for(lock, std::chrono::seconds(1), [&] { return here == 2; }) ? 1 : 0;
  });
  return met == 2;
}

/// On a busy machine the second thread may come too late for once: no library promises more.
TEST(TaskPool, PiecesAreDoneAtTheSameTime) {
  TaskPool pool(2);
  bool met = false;
  for (int tries = 0; tries < 60 && !met; ++tries) met = two_meet(pool);
  EXPECT_TRUE(met);
}

TEST(TaskPool, SlicesCoverAListWithoutGapOrOverlap) {
  for (const std::size_t count : {0U, 1U, 511U, 5000U, 100003U}) {
    TaskPool pool(3);
    std::vector<Slice> slices(pool.slices_of(count));
    EXPECT_EQ(pool.for_slices(count, [&](const Slice& slice, std::size_t k) { slices[k] = slice; }),
              slices.size());
    std::size_t end = 0;
    for (const Slice& slice : slices) {
      EXPECT_EQ(slice.begin, end);
      end = slice.end;
    }
    EXPECT_EQ(end, count);
  }
}

TEST(TaskPool, ASmallListIsNotCut) {
  EXPECT_EQ(TaskPool(8).slices_of(100), 1U);
  EXPECT_EQ(TaskPool(1).slices_of(1000000), 1U);
  EXPECT_GT(TaskPool(2).slices_of(1000000), 1U);
}

TEST(TaskPool, LeavesWorkToTheCallerWhereItIsNotShared) {
  TaskPool pool(4);
  pool.share_work(false);
  EXPECT_EQ(pool.threads(), 1U);
  EXPECT_EQ(pool.pieces(), 1U);
  EXPECT_EQ(pool.slices_of(1000000), 1U);
  std::vector<std::size_t> done;
  const auto caller = std::this_thread::get_id();
  pool.for_each(100, [&](std::size_t piece, std::size_t thread) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(thread, 0U);
    done.push_back(piece);
  });
  EXPECT_EQ(done.size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  pool.share_work(true);
  EXPECT_EQ(pool.threads(), 4U);
}

TEST(TaskPool, AnErrorReachesTheCaller) {
  TaskPool pool(2);
  EXPECT_THROW(pool.for_each(10,
                             [](std::size_t piece, std::size_t) {
                               if (piece == 3) throw std::runtime_error("x");
                             }),
               std::runtime_error);
}

TEST(TaskPool, RefusesToHaveNoThread) { EXPECT_THROW(TaskPool(0), std::invalid_argument); }

TEST(TaskPool, RefusesMoreThreadsThanAnyMachineUses) {
  for (const unsigned threads : {257U, std::numeric_limits<unsigned>::max()}) {
    try {
      const TaskPool pool(threads);
      ADD_FAILURE() << "it has " << pool.threads() << " threads";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()),
                "threads: " + std::to_string(threads) + " are too many; at most 256 can share the work");
    }
  }
}

}  // namespace
}  // namespace kerf::test

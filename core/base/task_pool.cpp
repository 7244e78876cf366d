#include "core/base/task_pool.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

unsigned checked_threads(unsigned threads) {
  if (threads == 0) throw std::invalid_argument("threads: at least one is needed");
  if (threads > TaskPool::kMostThreads)
    throw std::invalid_argument("threads: " + std::to_string(threads) + " are too many; at most " +
                                std::to_string(TaskPool::kMostThreads) + " can share the work");
  return threads;
}

}  // namespace

struct TaskPool::Arena {
  explicit Arena(unsigned threads) : tbb(static_cast<int>(threads)) {}
  tbb::task_arena tbb;
};

TaskPool::TaskPool(unsigned threads)
    : threads_(checked_threads(threads)), arena_(threads > 1 ? std::make_unique<Arena>(threads) : nullptr) {}

TaskPool::~TaskPool() = default;

std::size_t TaskPool::pieces() const { return threads() == 1 ? 1 : tuning::kPiecesPerThread * threads_; }

std::size_t TaskPool::slices_of(std::size_t count, std::size_t few) const {
  return std::clamp<std::size_t>(count / few, 1, pieces());
}

void TaskPool::share(std::size_t pieces, const std::function<void(std::size_t, std::size_t)>& work) {
  // Every piece takes the caller's rounding and denormal modes. A thread would otherwise keep the modes of
  // its first work, and find other pairs.
  tbb::task_group_context modes(tbb::task_group_context::isolated, tbb::task_group_context::default_traits |
                                                                       tbb::task_group_context::fp_settings);
  // oneTBB has no more threads than processors unless a control allows them. A control is for the whole
  // process, where the least one holds: so there is one only where it allows more, and only in here.
  std::optional<tbb::global_control> more;
  constexpr auto kLimit = tbb::global_control::max_allowed_parallelism;
  if (threads_ > static_cast<unsigned>(tbb::info::default_concurrency()) &&
      threads_ > tbb::global_control::active_value(kLimit))
    more.emplace(kLimit, threads_);
  arena_->tbb.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, pieces,
        [&](std::size_t k) {
          work(k, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
        },
        tbb::simple_partitioner(), modes);
  });
}

}  // namespace kerf

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "core/base/task_pool.h"
#include "core/bsp/thread_chooser.h"

namespace kerf {

/// The threads of a tree, and the clock by which it is decided whether they share the work of a step.
class ThreadUse {
 public:
  using Clock = std::chrono::steady_clock;

  /// See Bsp::set_threads.
  void set(unsigned threads, Sharing sharing) {
    if (threads == threads_ && sharing == sharing_) return;  // what trials have shown stays
    pool_ = std::make_unique<TaskPool>(threads);
    threads_ = threads;
    sharing_ = sharing;
    chooser_ = {};
    requests_ = {};
    decides_ = threads > 1 && sharing == Sharing::if_faster;
    pool_->share_work(!decides_);  // until it is known how many objects there are
    is_timed_ = false;
  }
  [[nodiscard]] TaskPool& pool() const { return *pool_; }

  /// The time, if it matters.
  [[nodiscard]] Clock::time_point now() const { return is_timed_ ? Clock::now() : Clock::time_point{}; }
  /// What has been done since `start` was taking requests, which is part of the next step.
  void end_requests(Clock::time_point start) {
    if (is_timed_) requests_ += Clock::now() - start;
  }
  /// A step that began at `start` is done.
  void end_step(Clock::time_point start, Mode mode, std::uint32_t objects) {
    if (!decides_) return;
    const std::chrono::duration<double> taken = now() - start + requests_;
    requests_ = {};
    is_timed_ = objects >= ThreadChooser::kFew;  // with fewer, a step is so short that a clock shows
    pool_->share_work(chooser_.choose(mode, objects, taken.count()));
  }

 private:
  std::unique_ptr<TaskPool> pool_ = std::make_unique<TaskPool>();
  unsigned threads_ = 1;
  Sharing sharing_ = Sharing::if_faster;
  ThreadChooser chooser_;
  Clock::duration requests_{};
  bool decides_ = false;
  bool is_timed_ = false;
};

}  // namespace kerf

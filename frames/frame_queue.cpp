#include "frames/frame_queue.h"

namespace kerf {

FrameQueue::FrameQueue(std::size_t capacity, std::function<void(FrameJob&)> finish_frame)
    : capacity_(capacity), finish_frame_(std::move(finish_frame)), thread_([this] { work(); }) {}

FrameQueue::~FrameQueue() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    jobs_.clear();
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void FrameQueue::add(FrameJob job) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || jobs_.size() < capacity_; });
    rethrow();
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void FrameQueue::finish() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  thread_.join();
  rethrow();
}

void FrameQueue::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void FrameQueue::work() {
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    FrameJob job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    changed_.notify_all();
    try {
      finish_frame_(job);
    } catch (...) {
      lock.lock();
      error_ = std::current_exception();
      lock.unlock();
      changed_.notify_all();
      return;
    }
  }
}

}  // namespace kerf

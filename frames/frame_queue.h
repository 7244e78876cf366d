#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "frames/manifest.h"
#include "viz/image/image.h"

namespace kerf {

/// A picture on its way to disk.
struct FrameJob {
  Image image;
  FrameRecord record;
};

/// Finishes frames on a second thread, in order, while the first one simulates and draws the next.
/// When finishing fails, nothing more is finished and the error comes out of the next `add` or `finish`.
class FrameQueue {
 public:
  /// `capacity` jobs at most wait; `add` blocks meanwhile.
  FrameQueue(std::size_t capacity, std::function<void(FrameJob&)> finish_frame);
  /// Waits for the frame at hand; those that wait are dropped.
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  void add(FrameJob job);
  /// Waits until every frame is finished.
  void finish();

 private:
  void work();
  void rethrow() const;

  std::size_t capacity_;
  std::function<void(FrameJob&)> finish_frame_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<FrameJob> jobs_;
  std::exception_ptr error_;
  bool closed_ = false;
  std::thread thread_;  ///< last: it starts when everything else is there
};

}  // namespace kerf

#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "frames/sequence/farm/frame_order.h"
#include "frames/sequence/farm/worker.h"

namespace kerf {

/// Memory shared with processes forked later, cut into slots of equal size. Unused pages take no memory.
class SharedSlots {
 public:
  /// Each slot has at least `least_bytes`, and much more if the system allows. Throws std::runtime_error.
  SharedSlots(std::size_t count, std::size_t least_bytes);
  ~SharedSlots();
  SharedSlots(const SharedSlots&) = delete;
  SharedSlots& operator=(const SharedSlots&) = delete;

  [[nodiscard]] const std::vector<SlotMemory>& slots() const { return slots_; }

 private:
  void* memory_ = nullptr;
  std::size_t size_ = 0;
  std::vector<SlotMemory> slots_;
};

/// Frames drawn by forked processes, each of which draws and writes its own, while this process simulates.
///
/// At most two frames a worker, and two more, are in flight, however slow disk and film encoder are. If a
/// worker dies, the others draw its frames; a frame that killed two workers is an error. Construct it before
/// this process has threads or GL.
class ForkedCrew final : public FrameCrew {
 public:
  /// `image_bytes`: of the largest picture whose pixels come back. Throws std::runtime_error if the system
  /// refuses so many processes or so much memory.
  ForkedCrew(int workers, std::size_t image_bytes, const StartFrameMaker& start, Deliver deliver);
  ~ForkedCrew() override;

  void add(FrameOrder order) override;
  void finish() override;

 private:
  struct Task {
    FrameOrder order;
    std::uint32_t slot = 0;
    std::size_t parcel_bytes = 0;
    int worker = -1;         ///< that has it; -1: it waits
    std::uint64_t turn = 0;  ///< a worker does its tasks in the order of their turns
    int losses = 0;          ///< workers that died while they did it
    bool done = false;
    Image image;
  };

  void rethrow() const;
  void wake() const;
  void stop();
  void run();
  bool hand_out();
  void hand_to(std::size_t worker, std::uint64_t ticket, Task& task);
  [[nodiscard]] std::size_t load_of(std::size_t worker) const;
  [[nodiscard]] std::optional<std::size_t> idlest_worker() const;
  void wait_for_news();
  void take_reply(std::size_t worker);
  void finish_task(const WorkerReply& reply);
  Task* task_at_hand(std::size_t worker);
  void bury(std::size_t worker);
  void deliver_finished(bool with_gaps);
  void note_error(const std::exception_ptr& error);

  SharedSlots slots_;
  std::size_t image_bytes_;
  std::vector<Worker> workers_;
  Deliver deliver_;
  int wake_ = -1;  ///< an eventfd that ends the thread's wait

  mutable std::mutex mutex_;  ///< guards the members below; tasks at a worker belong to the thread
  std::condition_variable changed_;
  std::vector<std::uint32_t> free_slots_;
  std::map<std::uint64_t, Task> tasks_;  ///< by ticket: not yet delivered
  std::deque<std::uint64_t> waiting_;
  std::uint64_t next_ticket_ = 0;
  std::uint64_t next_turn_ = 0;
  bool closed_ = false;
  std::exception_ptr error_;
  std::thread thread_;  ///< last: it starts when everything else exists
};

}  // namespace kerf

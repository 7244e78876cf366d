#include "frames/sequence/farm/forked_crew.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace kerf {
namespace {

/// A worker has its next frame at hand when it finishes one.
constexpr std::size_t kAhead = 2;
constexpr int kMostLosses = 2;
constexpr std::size_t kLeastParcel = std::size_t{8} << 20U;

std::size_t slots_for(int workers) { return kAhead * static_cast<std::size_t>(workers) + 2; }

}  // namespace

ForkedCrew::ForkedCrew(int workers, std::size_t image_bytes, const StartFrameMaker& start, Deliver deliver)
    : slots_(slots_for(workers), image_bytes + kLeastParcel),
      image_bytes_(image_bytes),
      deliver_(std::move(deliver)),
      free_slots_(slots_.slots().size()) {
  std::iota(free_slots_.begin(), free_slots_.end(), 0U);
  std::vector<int> sockets;
  for (int i = 0; i < workers; ++i) {
    workers_.emplace_back(start, slots_.slots(), sockets);
    sockets.push_back(workers_.back().socket());
  }
  wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (wake_ < 0) throw std::runtime_error("no eventfd; too many files are open");
  thread_ = std::thread([this] { run(); });
}

ForkedCrew::~ForkedCrew() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  stop();
  close(wake_);
}

void ForkedCrew::stop() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  wake();
  if (thread_.joinable()) thread_.join();
  workers_.clear();
}

void ForkedCrew::finish() {
  stop();
  rethrow();
}

void ForkedCrew::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void ForkedCrew::wake() const {
  const std::uint64_t one = 1;
  // A full counter wakes the thread as well.
  [[maybe_unused]] const ssize_t ignored = ::write(wake_, &one, sizeof one);
}

void ForkedCrew::add(FrameOrder order) {
  std::uint32_t slot = 0;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || !free_slots_.empty(); });
    rethrow();
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  const SlotMemory memory = slots_.slots()[slot];
  if (order.parcel.size() + image_bytes_ > memory.size())
    throw std::runtime_error("a frame of " + std::to_string(order.record.objects) +
                             " objects is too large to be shared; draw with --workers 0");
  std::memcpy(memory.data(), order.parcel.data(), order.parcel.size());
  Task task;
  task.slot = slot;
  task.parcel_bytes = order.parcel.size();
  task.order = std::move(order);
  task.order.parcel = {};
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(next_ticket_);
    tasks_.emplace(next_ticket_++, std::move(task));
  }
  wake();
}

/// The thread's main loop. Only this thread talks to workers.
void ForkedCrew::run() {
  while (hand_out()) {
    wait_for_news();
    deliver_finished(false);
  }
  deliver_finished(true);
}

/// False when nothing is left to wait for.
bool ForkedCrew::hand_out() {
  const std::lock_guard lock(mutex_);
  while (!error_ && !waiting_.empty()) {
    const auto worker = idlest_worker();
    if (!worker) break;
    const std::uint64_t ticket = waiting_.front();
    waiting_.pop_front();
    hand_to(*worker, ticket, tasks_.at(ticket));
  }
  const auto is_out = [](const auto& entry) { return entry.second.worker >= 0; };
  if (std::ranges::any_of(tasks_, is_out)) return true;
  return !error_ && !(closed_ && waiting_.empty());
}

std::size_t ForkedCrew::load_of(std::size_t worker) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      tasks_, [&](const auto& entry) { return entry.second.worker == static_cast<int>(worker); }));
}

std::optional<std::size_t> ForkedCrew::idlest_worker() const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    if (!workers_[i].is_alive() || load_of(i) >= kAhead) continue;
    if (!best || load_of(i) < load_of(*best)) best = i;
  }
  return best;
}

/// If the worker has died, the read from its socket shows it.
void ForkedCrew::hand_to(std::size_t worker, std::uint64_t ticket, Task& task) {
  WorkerOrder order;
  order.ticket = ticket;
  order.slot = task.slot;
  order.parcel_bytes = task.parcel_bytes;
  order.has_kept = task.order.kept.has_value();
  order.kept = task.order.kept.value_or(0);
  order.wants_image = task.order.wants_image;
  std::strncpy(order.file, task.order.record.file.c_str(), sizeof order.file - 1);
  task.worker = static_cast<int>(worker);
  task.turn = next_turn_++;
  workers_[worker].send(order);
}

void ForkedCrew::wait_for_news() {
  std::vector<pollfd> ends{{wake_, POLLIN, 0}};
  for (const Worker& worker : workers_) ends.push_back({worker.socket(), POLLIN, 0});
  if (poll(ends.data(), ends.size(), -1) < 0) return;
  std::uint64_t woken = 0;
  if (ends[0].revents != 0 && ::read(wake_, &woken, sizeof woken) < 0) woken = 0;
  for (std::size_t i = 0; i < workers_.size(); ++i)
    if (ends[i + 1].revents != 0) take_reply(i);
}

void ForkedCrew::take_reply(std::size_t worker) {
  if (const auto reply = workers_[worker].receive()) {
    finish_task(*reply);
  } else {
    bury(worker);
  }
}

void ForkedCrew::finish_task(const WorkerReply& reply) {
  const std::lock_guard lock(mutex_);
  Task& task = tasks_.at(reply.ticket);
  task.worker = -1;
  if (!reply.done) {
    note_error(std::make_exception_ptr(std::runtime_error(reply.trouble)));
    return;
  }
  task.done = true;
  task.order.record.pixel_hash = reply.pixel_hash;
  if (!task.order.wants_image) return;
  const std::size_t bytes =
      4 * static_cast<std::size_t>(reply.width) * static_cast<std::size_t>(reply.height);
  const SlotMemory pixels = slots_.slots()[task.slot].subspan(task.parcel_bytes, bytes);
  task.image = {reply.width, reply.height, {pixels.begin(), pixels.end()}};
}

/// The task that a worker was doing, of all that it has; null if it has none.
ForkedCrew::Task* ForkedCrew::task_at_hand(std::size_t worker) {
  Task* first = nullptr;
  for (auto& [ticket, task] : tasks_)
    if (task.worker == static_cast<int>(worker) && (first == nullptr || task.turn < first->turn))
      first = &task;
  return first;
}

/// The worker's parcels are still in their slots: the pixels come behind them. Only the task that it was
/// doing may be to blame.
void ForkedCrew::bury(std::size_t worker) {
  const std::string end = "a process that draws " + workers_[worker].end();
  const std::lock_guard lock(mutex_);
  const Task* const suspect = task_at_hand(worker);
  const bool any_left = std::ranges::any_of(workers_, [](const Worker& w) { return w.is_alive(); });
  for (auto task = tasks_.rbegin(); task != tasks_.rend(); ++task) {
    if (task->second.worker != static_cast<int>(worker)) continue;
    task->second.worker = -1;
    waiting_.push_front(task->first);
    const bool hopeless = &task->second == suspect && ++task->second.losses >= kMostLosses;
    if (hopeless || !any_left)
      note_error(std::make_exception_ptr(
          std::runtime_error(end + " while it drew " + task->second.order.record.file +
                             (hopeless ? ", and so did another one before" : ", and it was the last one") +
                             "; the finished frames are kept, go on with --resume")));
  }
  if (!any_left && !error_) note_error(std::make_exception_ptr(std::runtime_error(end)));
  if (!error_) std::fprintf(stderr, "kerf: %s; the others draw its frames\n", end.c_str());
}

/// In order; with gaps only when no more will come.
void ForkedCrew::deliver_finished(bool with_gaps) {
  for (;;) {
    std::unique_lock lock(mutex_);
    const auto is_done = [](const auto& entry) { return entry.second.done; };
    const auto next = with_gaps ? std::ranges::find_if(tasks_, is_done) : tasks_.begin();
    if (next == tasks_.end() || !next->second.done) return;
    const Task task = std::move(next->second);
    tasks_.erase(next);
    free_slots_.push_back(task.slot);
    lock.unlock();
    changed_.notify_all();
    try {
      deliver_(task.order.record, task.image);
    } catch (...) {
      lock.lock();
      note_error(std::current_exception());
    }
  }
}

/// The first error counts. The lock is held.
void ForkedCrew::note_error(const std::exception_ptr& error) {
  if (!error_) error_ = error;
  changed_.notify_all();
}

SharedSlots::SharedSlots(std::size_t count, std::size_t least_bytes) {
  constexpr std::size_t kPage = 4096;
  constexpr std::size_t kPlenty = std::size_t{512} << 20U;
  const std::size_t least = (least_bytes + kPage - 1) / kPage * kPage;
  memory_ = MAP_FAILED;
  std::size_t each = std::max(least, kPlenty);
  for (; memory_ == MAP_FAILED && each >= std::max(least, kPage); each /= 2) {
    size_ = count * each;
    memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ != MAP_FAILED) break;
  }
  if (memory_ == MAP_FAILED)
    throw std::runtime_error("not enough memory to share frames with " + std::to_string(count) +
                             " slots; ask for fewer with --workers");
  for (std::size_t i = 0; i < count; ++i)
    slots_.emplace_back(static_cast<std::uint8_t*>(memory_) + i * each, each);
}

SharedSlots::~SharedSlots() { munmap(memory_, size_); }

}  // namespace kerf

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "frames/sequence/farm/frame_order.h"

namespace kerf {

/// Memory that the parent and its workers share: room for one frame's parcel on its way there and for its
/// pixels on their way back.
using SlotMemory = std::span<std::uint8_t>;

/// The order to a worker, in one message.
struct WorkerOrder {
  std::uint64_t ticket = 0;
  std::uint32_t slot = 0;
  std::size_t parcel_bytes = 0;
  std::uint64_t kept = 0;
  bool has_kept = false;
  bool wants_image = false;
  char file[256]{};
};

/// The worker's reply.
struct WorkerReply {
  std::uint64_t ticket = 0;
  std::uint64_t pixel_hash = 0;
  bool done = false;
  int width = 0;  ///< of the image in the slot
  int height = 0;
  char trouble[1024]{};
};

/// A forked process that draws. It ends by itself when this end of its socket closes, even by the death of
/// this process.
class Worker {
 public:
  /// `elder`: ends of sockets that the child must not keep open. Throws std::runtime_error if the system
  /// refuses another process.
  Worker(const StartFrameMaker& start, std::span<const SlotMemory> slots, std::span<const int> elder);
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&&) = delete;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { (void)end(); }

  [[nodiscard]] int socket() const { return socket_; }
  [[nodiscard]] bool is_alive() const { return process_ > 0; }
  /// If the worker has died, `receive` shows it.
  void send(const WorkerOrder& order) const;
  /// None if the worker has died.
  [[nodiscard]] std::optional<WorkerReply> receive() const;
  /// Closes the socket, waits for the process and returns how it ended.
  std::string end();

 private:
  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace kerf

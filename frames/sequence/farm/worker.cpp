#include "frames/sequence/farm/worker.h"

#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "viz/gl/context.h"

namespace kerf {
namespace {

template <class Message>
bool send_message(int socket, const Message& message) {
  for (;;) {
    const ssize_t sent = ::send(socket, &message, sizeof message, MSG_NOSIGNAL);
    if (sent >= 0 || errno != EINTR) return sent == static_cast<ssize_t>(sizeof message);
  }
}

template <class Message>
std::optional<Message> receive_message(int socket) {
  Message message;
  for (;;) {
    const ssize_t got = ::recv(socket, &message, sizeof message, 0);
    if (got == static_cast<ssize_t>(sizeof message)) return message;
    if (got >= 0 || errno != EINTR) return std::nullopt;
  }
}

WorkerReply work_on(const WorkerOrder& order, FrameMaker& maker, SlotMemory slot) {
  WorkerReply reply;
  const auto kept = order.has_kept ? std::optional(order.kept) : std::nullopt;
  const FrameMaker::Made made = maker.make(order.file, slot.first(order.parcel_bytes), kept);
  reply.pixel_hash = made.pixel_hash;
  reply.done = true;
  if (!order.wants_image) return reply;
  reply.width = made.image->width;
  reply.height = made.image->height;
  const SlotMemory pixels = slot.subspan(order.parcel_bytes, made.image->rgba.size());
  std::memcpy(pixels.data(), made.image->rgba.data(), pixels.size());
  return reply;
}

/// The child's main loop. An error ends the frame, not the worker: the parent decides what follows.
void serve(int socket, const StartFrameMaker& start, std::span<const SlotMemory> slots) {
  std::unique_ptr<FrameMaker> maker;
  while (const auto order = receive_message<WorkerOrder>(socket)) {
    WorkerReply reply;
    try {
      if (!maker) maker = start();
      reply = work_on(*order, *maker, slots[order->slot]);
    } catch (const std::bad_alloc&) {
      std::strncpy(reply.trouble,
                   "not enough memory to draw a frame; ask for smaller pictures or fewer objects",
                   sizeof reply.trouble - 1);
    } catch (const std::exception& error) {
      std::strncpy(reply.trouble, error.what(), sizeof reply.trouble - 1);
    }
    reply.ticket = order->ticket;
    if (!send_message(socket, reply)) return;
  }
}

/// Ctrl-C reaches the whole process group; only the parent acts on it. Each worker keeps one core busy by
/// itself: the rasteriser's own threads would only get in each other's way.
void settle_in_child() {
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_IGN);
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  setenv("LP_NUM_THREADS", "0", 1);
  tune_allocator_for_rendering();
}

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string("cannot start a process that draws: ") + what + ": " +
                           std::generic_category().message(errno) + "; ask for fewer with --workers");
}

}  // namespace

Worker::Worker(const StartFrameMaker& start, std::span<const SlotMemory> slots, std::span<const int> elder) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("no socket");
  std::fflush(nullptr);
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    for (const int socket : elder) close(socket);
    settle_in_child();
    serve(ends[1], start, slots);
    _exit(0);
  }
  const int error = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (process_ > 0) return;
  close(socket_);
  errno = error;
  fail("no process");
}

Worker::Worker(Worker&& other) noexcept
    : process_(std::exchange(other.process_, -1)), socket_(std::exchange(other.socket_, -1)) {}

void Worker::send(const WorkerOrder& order) const { (void)send_message(socket_, order); }

std::optional<WorkerReply> Worker::receive() const { return receive_message<WorkerReply>(socket_); }

std::string Worker::end() {
  if (process_ <= 0) return {};
  close(std::exchange(socket_, -1));
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFSIGNALED(status) ? "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
                                   strsignal(WTERMSIG(status)) + ")"
                             : "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace kerf

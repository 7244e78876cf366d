#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "core/base/tuning.h"

namespace kerf {

/// The part [begin, end) of a list.
struct Slice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Piece `k` of `count` things in `pieces` of nearly equal size.
constexpr Slice slice(std::size_t count, std::size_t pieces, std::size_t k) {
  return {count * k / pieces, count * (k + 1) / pieces};
}

/// Threads that share independent pieces of work.
class TaskPool {
 public:
  static constexpr unsigned kMostThreads = 256;

  /// The number of threads at work, the caller's included; at most the number of processors. With one thread,
  /// all work is done by the caller and no thread is created. Throws std::invalid_argument for 0 and for more
  /// than kMostThreads.
  explicit TaskPool(unsigned threads = 1);
  TaskPool(const TaskPool&) = delete;
  TaskPool& operator=(const TaskPool&) = delete;
  ~TaskPool();

  /// Those that share work now.
  [[nodiscard]] unsigned threads() const { return shares_ ? threads_ : 1; }
  /// Whether work is shared from now on, as it is to begin with, or done by the caller.
  void share_work(bool on) { shares_ = on; }
  /// The number of pieces into which work should be cut, so that no thread waits long for the last one.
  [[nodiscard]] std::size_t pieces() const;
  /// Does each piece once, several at a time and in no order; returns when all are done. Calls
  /// `work(piece, thread)` with the thread that does it, which is below `threads()`.
  template <class Work>
  void for_each(std::size_t pieces, Work work) {
    if (arena_ && shares_ && pieces > 1) return share(pieces, std::ref(work));
    for (std::size_t k = 0; k < pieces; ++k) work(k, std::size_t{0});
  }
  /// The same for the slices of a list of `count` small things, of at least `few` each; `work(slice, piece)`.
  /// Gives their number.
  template <class SliceWork>
  std::size_t for_slices(std::size_t count, SliceWork work, std::size_t few = tuning::kFewThings) {
    const std::size_t number = slices_of(count, few);
    for_each(number, [&](std::size_t piece, std::size_t) { work(slice(count, number, piece), piece); });
    return number;
  }
  /// The number of slices of such a list: 1 where sharing costs more than it gives.
  [[nodiscard]] std::size_t slices_of(std::size_t count, std::size_t few = tuning::kFewThings) const;

 private:
  struct Arena;
  void share(std::size_t pieces, const std::function<void(std::size_t piece, std::size_t thread)>& work);

  unsigned threads_;
  bool shares_ = true;
  std::unique_ptr<Arena> arena_;
};

}  // namespace kerf

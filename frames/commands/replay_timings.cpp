#include "frames/commands/replay_timings.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/base/median.h"
#include "core/base/random.h"
#include "core/replay/replayer.h"
#include "frames/support/memory_use.h"

namespace kerf {
namespace {

constexpr int kSeeks = 100;
constexpr int kBacks = 20;  ///< steps back after each seek

/// The times of some work, in milliseconds.
class Times {
 public:
  template <class Work>
  void time(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    times_.push_back(taken.count());
  }
  void print(const char* what) {
    std::ranges::sort(times_);
    const auto quantile = [this](double q) {
      return times_[static_cast<std::size_t>(q * static_cast<double>(times_.size() - 1))];
    };
    std::printf("%s: median %.2f ms, p95 %.2f ms, most %.2f ms (%zu of them)\n", what, median(times_),
                quantile(0.95), quantile(1), times_.size());
  }

 private:
  std::vector<double> times_;
};

template <int D>
void print_timings(const std::filesystem::path& file) {
  Times open;
  Times seek;
  Times back;
  std::unique_ptr<Replayer<D>> replayer;
  open.time([&] { replayer = std::make_unique<Replayer<D>>(std::make_shared<RecordingReader<D>>(file)); });
  const std::uint32_t steps = replayer->recording().steps();
  Random random(1);
  for (int k = 0; k < kSeeks; ++k) {
    const std::uint32_t step = random.below(steps + 1);
    seek.time([&] { replayer->seek(step); });
    for (int b = 0; b < kBacks && replayer->step() > 0; ++b)
      back.time([&] { replayer->seek(replayer->step() - 1); });
  }
  open.print("open");
  seek.print("seek");
  back.print("one step back");
}

}  // namespace

void print_replay_timings(const std::filesystem::path& file) {
  if (read_recording_info(file).dimension == 2) {
    print_timings<2>(file);
  } else {
    print_timings<3>(file);
  }
  std::printf("memory: %.0f MB at most\n", static_cast<double>(peak_own_memory()) * 1e-6);
}

}  // namespace kerf

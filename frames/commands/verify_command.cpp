#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "core/base/median.h"
#include "core/base/random.h"
#include "core/replay/replayer.h"
#include "core/replay/verify.h"
#include "frames/commands/command.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/machine.h"
#include "frames/support/parse_number.h"

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

/// Opens a recording as a debugger does, goes to random steps and from there back step by step; prints the
/// times and the memory. Throws std::runtime_error if the recording cannot be read.
void print_replay_timings(const std::filesystem::path& file) {
  if (read_recording_info(file).dimension == 2) {
    print_timings<2>(file);
  } else {
    print_timings<3>(file);
  }
  std::printf("memory: %.0f MB at most\n", static_cast<double>(peak_own_memory()) * 1e-6);
}

unsigned long long wide(std::uint64_t x) { return x; }

std::uint32_t parse_every(const std::string& text) {
  if (text.empty()) return 1;
  return parse_whole("--oracle-every", text, 0U, UINT32_MAX);
}

void print(const Divergence& divergence, const GivenNames& names) {
  const std::string event = divergence.event ? ", event e" + std::to_string(*divergence.event) : "";
  std::printf("diverges first in step %s%s\n  recorded: %s\n  replayed: %s\n",
              names.step(divergence.step).c_str(), event.c_str(), divergence.recorded.c_str(),
              divergence.replayed.c_str());
}

void print(const Verdict& verdict, bool oracle) {
  std::printf("replayed %s, %s, %s, %s\n", counted(verdict.steps, "step").c_str(),
              counted(verdict.events, "event").c_str(), counted(verdict.pairs, "pair").c_str(),
              counted(verdict.keyframes, "keyframe").c_str());
  if (!verdict.shapes.empty()) std::printf("shapes: %s\n", verdict.shapes.c_str());
  if (verdict.change) std::printf("changed after it was recorded: %s\n", verdict.change->what.c_str());
  if (verdict.divergence) {
    print(*verdict.divergence, verdict.names);
  } else if (!verdict.change) {
    std::printf("every event, figure, state hash, keyframe and set of pairs is as recorded\n");
  }
  if (oracle && verdict.judged == 0) {
    std::printf("oracle: asked in no step\n");
  } else if (oracle) {
    std::printf("oracle: %llu missed, %llu extra, %llu twice\n", wide(verdict.missed), wide(verdict.extra),
                wide(verdict.twice));
  }
  if (const TheirStep& theirs = verdict.theirs; theirs != TheirStep{})
    std::printf("theirs: %s, %llu missed, %llu extra, %llu twice, %llu ignored%s\n",
                counted(theirs.pairs, "pair").c_str(), wide(theirs.missed), wide(theirs.extra),
                wide(theirs.twice), wide(theirs.ignored),
                theirs.undecided > 0 ? (", " + std::to_string(theirs.undecided) + " undecided").c_str() : "");
  for (const std::string& what : verdict.unchecked) std::printf("not checked: %s\n", what.c_str());
}

class VerifyCommand final : public Command {
 public:
  explicit VerifyCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string oracle_every_;
  bool timings_ = false;
};

VerifyCommand::VerifyCommand(CLI::App& program)
    : Command(program, "verify", "Replay a recording and compare it with itself and the oracle") {
  option("FILE", file_, "A recording", "")->required();
  option("--oracle-every", oracle_every_, "Ask brute force every N steps (default 1; 0: never)", "N");
  command_->add_flag("--timings", timings_, "Also measure how fast steps are reached");
}

void VerifyCommand::run() const {
  const std::uint32_t every = parse_every(oracle_every_);
  const InterruptGuard interrupt;
  const Verdict verdict =
      verify(file_, every, [&](std::uint32_t /*step*/) { return !interrupt.requested(); });
  print(verdict, every != 0);
  if (const std::string why = why_unjudged(verdict, every); !why.empty() && !interrupt.requested())
    throw UsageError("--oracle-every " + oracle_every_ + ": " + why);
  if (timings_) print_replay_timings(file_);
  if (interrupt.requested())
    throw Interrupted("interrupted: the steps after " + verdict.names.step(verdict.steps) +
                      " were not verified");
  if (verdict.divergence) throw DoesNotHold("the replay is not the run that was recorded");
  if (verdict.change) throw DoesNotHold("the recording was changed after it was written");
  if (!verdict.holds())
    throw DoesNotHold("pairs are wrong, first in step " + verdict.names.step(verdict.first_wrong_step));
}

}  // namespace

AnyCommand make_verify_command(CLI::App& program) { return std::make_unique<VerifyCommand>(program); }

}  // namespace kerf

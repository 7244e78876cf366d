#include "tests/hard/trial.h"

#include <sys/time.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "core/tree/validate.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/hard/scan_oracle.h"

namespace kerf::test {
namespace {

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Sends this process SIGPROF unless it ends within that much processor time; 0 is for ever.
class Countdown {
 public:
  explicit Countdown(double ms) {
    if (ms > 0) set(ms);
  }
  Countdown(const Countdown&) = delete;
  Countdown& operator=(const Countdown&) = delete;
  ~Countdown() { set(0); }

 private:
  static void set(double ms) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(ms / 1e3);
    timer.it_value.tv_usec = static_cast<suseconds_t>(std::fmod(ms, 1e3) * 1e3);
    setitimer(ITIMER_PROF, &timer, nullptr);
  }
};

std::string to_string(const Pair& pair) {
  return std::to_string(pair.a.value) + "-" + std::to_string(pair.b.value);
}

/// Counts the differences between the reported pairs and the right ones.
void compare(std::span<const Pair> reported, const std::vector<Pair>& right, Trial& trial) {
  std::vector<Pair> found(reported.begin(), reported.end());
  std::sort(found.begin(), found.end());
  const std::string when = " in step " + std::to_string(trial.steps);
  auto want = right.begin();
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i > 0 && found[i] == found[i - 1]) {
      if (trial.twice++ == 0) note(trial, to_string(found[i]) + " reported twice" + when);
      continue;
    }
    for (; want != right.end() && *want < found[i]; ++want)
      if (trial.missed++ == 0) note(trial, to_string(*want) + " missed" + when);
    if (want != right.end() && *want == found[i]) {
      ++want;
    } else if (trial.extra++ == 0) {
      note(trial, to_string(found[i]) + " is no pair" + when);
    }
  }
  if (want != right.end() && trial.missed == 0) note(trial, to_string(*want) + " missed" + when);
  trial.missed += static_cast<std::uint64_t>(right.end() - want);
  trial.pairs = std::max<std::uint64_t>(trial.pairs, found.size());
}

/// Makes the requests of a step and times them with it. Answers are ours to judge only where `judge` says so.
template <int D>
void step(const ScriptStep<D>& given, BroadPhase<D>& subject, Feed feed, bool judge, Trial& trial) {
  const Countdown countdown(trial.limit_ms > 0 ? std::max(trial.limit_ms - trial.total_ms, 1.0) : 0);
  const double start = processor_ms();
  for (const Request<D>& request : given.requests) {
    const Status status = ask(subject, request, feed);
    if (!judge || status == request.expected) continue;
    if (trial.statuses++ == 0)
      note(trial, "object " + std::to_string(request.object.value) + ": " +
                      std::string(kerf::to_string(status)) + ", not " +
                      std::string(kerf::to_string(request.expected)) + ", in step " +
                      std::to_string(trial.steps));
  }
  subject.step();
  const double took = processor_ms() - start;
  trial.worst_ms = std::max(trial.worst_ms, took);
  trial.total_ms += took;
}

template <int D>
void check_tree(const Bsp<D>& bsp, bool thoroughly, Trial& trial) {
  const Statistics s = bsp.statistics();
  trial.objects = std::max(trial.objects, s.objects);
  trial.height = std::max(trial.height, s.height);
  if (s.objects > 0) trial.entries = std::max(trial.entries, s.redundancy + 1);
  std::uint64_t acted = 0;
  for (std::size_t op = 0; op < s.operators.size(); ++op) acted += s.operators[op] - trial.operators[op];
  trial.operators = s.operators;
  trial.most_operators = std::max(trial.most_operators, static_cast<std::uint32_t>(acted));
  // Without a budget no operator may act; a partitioner that is shifted may gain some straddlers again.
  const double cap = 2 * static_cast<double>(bsp.config().max_entries) + 1;
  if (bsp.config().budget_divisor != 0 && s.redundancy + 1 > cap && trial.violations++ == 0)
    note(trial,
         std::to_string(s.redundancy + 1) + " entries an object in step " + std::to_string(trial.steps));
  if (!thoroughly) return;
  for (const Violation& violation : validate(bsp.tree())) {
    if (trial.violations++ == 0)
      note(trial, violation.what + " at n" + std::to_string(violation.node.value) + " in step " +
                      std::to_string(trial.steps));
  }
}

}  // namespace

void note(Trial& trial, std::string_view text) {
  if (trial.note[0] != 0) return;
  std::copy_n(text.begin(), std::min(text.size(), trial.note.size() - 1), trial.note.begin());
}

Trial worse(const Trial& a, const Trial& b) {
  Trial t = a;
  t.steps = std::min(a.steps, b.steps);
  t.objects = std::max(a.objects, b.objects);
  t.pairs = std::max(a.pairs, b.pairs);
  t.missed += b.missed;
  t.extra += b.extra;
  t.twice += b.twice;
  t.statuses += b.statuses;
  t.violations += b.violations;
  t.height = std::max(a.height, b.height);
  t.entries = std::max(a.entries, b.entries);
  t.worst_ms = std::max(a.worst_ms, b.worst_ms);
  t.total_ms += b.total_ms;
  for (std::size_t op = 0; op < t.operators.size(); ++op) t.operators[op] += b.operators[op];
  t.most_operators = std::max(a.most_operators, b.most_operators);
  if (a.note[0] == 0) t.note = b.note;
  return t;
}

template <int D>
Truth find_truth(const Script<D>& script, VolumeKind kind, Feed feed) {
  ScanOracle<D> oracle(kind);
  Truth truth;
  for (const ScriptStep<D>& given : script) {
    for (const Request<D>& request : given.requests) (void)ask<D>(oracle, request, feed);
    oracle.step();
    const std::span<const Pair> pairs = oracle.pairs();
    const bool same = !truth.empty() && std::ranges::equal(*truth.back(), pairs);
    truth.push_back(same ? truth.back()
                         : std::make_shared<const std::vector<Pair>>(pairs.begin(), pairs.end()));
  }
  return truth;
}

template <int D>
void play(const Script<D>& script, const Truth& truth, BroadPhase<D>& subject, Trial& trial) {
  for (std::size_t i = 0; i < script.size(); ++i) {
    step(script[i], subject, Feed::boxes, false, trial);
    compare(subject.pairs(), *truth[i], trial);
    ++trial.steps;
  }
}

template <int D>
void play_kerf(const Script<D>& script, const Truth& truth, const Setting& setting, Trial& trial) {
  Config config;
  apply(config, setting.config);
  Bsp<D> bsp(config, setting.kind);
  const FlushToZero flush(setting.flush_to_zero);
  for (std::size_t i = 0; i < script.size(); ++i) {
    if (!script[i].config.empty()) {
      apply(config, script[i].config);
      bsp.set_config(config);
    }
    step<D>(script[i], bsp, setting.feed, true, trial);
    compare(bsp.pairs(), *truth[i], trial);
    check_tree(bsp, i % setting.validate_every == 0 || i + 1 == script.size(), trial);
    ++trial.steps;
  }
}

#define KERF_INSTANTIATE(D)                                                      \
  template Truth find_truth<D>(const Script<D>&, VolumeKind, Feed);              \
  template void play<D>(const Script<D>&, const Truth&, BroadPhase<D>&, Trial&); \
  template void play_kerf<D>(const Script<D>&, const Truth&, const Setting&, Trial&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf::test

#include "frames/bench/participant.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "core/base/counted.h"
#include "core/base/median.h"

namespace kerf {
namespace {

constexpr double kLongestBuild = 10;   // over the patience
constexpr double kLongestRequest = 2;  // likewise

std::string in_seconds(double seconds) { return std::to_string(static_cast<int>(seconds + 0.5)) + " s"; }

}  // namespace

Participant::Participant(std::string name, std::uint32_t block, const CellPlan& plan)
    : plan_(plan),
      name_(std::move(name)),
      answers_(block),
      nanoseconds_(plan.steps, kNever),
      added_(plan.steps, kNever),
      missed_(plan.steps),
      extra_(plan.steps) {}

void Participant::start(const Life& life) {
  spent_ = 0;
  round_.clear();
  if (trouble_.empty()) process_ = std::make_unique<ChildProcess>(life);
}

bool Participant::ask(Request request, double limit, const CellWatch& watch) {
  if (!process_) return false;
  const bool done =
      process_->ask(static_cast<char>(request), std::chrono::duration<double>(limit), watch.stop);
  if (done) return true;
  trouble_ = process_->trouble();
  process_.reset();
  return false;
}

void Participant::build(const CellWatch& watch) {
  if (ask(Request::build, kLongestBuild * plan_.patience, watch))
    build_ = std::min(build_, answers_.step(0).nanoseconds);
}

void Participant::run(std::int64_t first, std::uint32_t count, const CellWatch& watch) {
  if (!ask(Request::run, kLongestRequest * plan_.patience, watch)) return;
  for (std::uint32_t k = 0; k < count; ++k) {
    keep(first + k, answers_.step(k));
    // Measured time, not time on the wall: what else the machine does leaves nothing out.
    spent_ += static_cast<double>(answers_.step(k).nanoseconds) * 1e-9;
  }
  const bool last = first + count >= plan_.steps;
  if (spent_ <= plan_.patience || last) return;
  trouble_ =
      "left out after " + in_seconds(spent_) + " and " +
      counted(static_cast<std::uint64_t>(first + static_cast<std::int64_t>(count + plan_.warm_up)), "step");
  ask(Request::account, kLongestRequest * plan_.patience, watch);
  bytes_ = answers_.account().bytes;
  process_.reset();
}

void Participant::keep(std::int64_t step, const StepResult& result) {
  if (step < 0) return;
  const auto k = static_cast<std::size_t>(step);
  round_.push_back(result.nanoseconds);
  nanoseconds_[k] = std::min(nanoseconds_[k], result.nanoseconds);
  added_[k] = std::min(added_[k], result.added);
  pairs_ += result.pairs;
  missed_[k] = std::max(missed_[k], result.missed);
  extra_[k] = std::max(extra_[k], result.extra);
  ++steps_;
}

void Participant::finish(const CellWatch& watch) {
  if (ask(Request::account, kLongestRequest * plan_.patience, watch)) bytes_ = answers_.account().bytes;
  if (plan_.tests && !tests_per_pair_ && trouble_.empty()) count_tests(watch);
  process_.reset();
  if (round_.size() < plan_.steps) return;
  round_medians_.push_back(median({round_.begin(), round_.end()}));
}

/// One that cannot say it has been measured all the same.
void Participant::count_tests(const CellWatch& watch) {
  if (!ask(Request::tests, kLongestRequest * plan_.patience, watch)) trouble_.clear();
  const Account& account = answers_.account();
  if (process_ && account.tests != kUnknown && account.pairs > 0)
    tests_per_pair_ = static_cast<double>(account.tests) / static_cast<double>(account.pairs);
}

std::optional<BenchRow> Participant::row(const CellName& cell, bool trace) const {
  const auto per_object = [&cell](const std::vector<std::uint64_t>& times) {
    std::vector<double> each;
    for (const std::uint64_t time : times)
      if (time != kNever) each.push_back(static_cast<double>(time) / cell.objects);
    return each;
  };
  BenchRow row;
  for (const double time : round_medians_) row.round_ns.push_back(time / cell.objects);
  const std::vector<double> each = per_object(nanoseconds_);
  if (each.empty()) return std::nullopt;
  row.cell = cell;
  row.algorithm = name_;
  if (trace) row.step_ns.assign(each.begin(), each.end());
  set_times(row, each);
  // A disturbed measurement of what is subtracted would make the rest too short: the least of each.
  std::vector<std::uint64_t> rest = nanoseconds_;
  for (std::size_t k = 0; k < rest.size(); ++k)
    if (rest[k] != kNever) rest[k] -= std::min(added_[k], rest[k]);
  row.native_ns = median(per_object(rest));
  row.build_ns = build_ == kNever ? 0 : static_cast<double>(build_) / cell.objects;
  row.pairs = pairs_ / steps_;
  row.missed = std::accumulate(missed_.begin(), missed_.end(), std::uint64_t{0});
  row.extra = std::accumulate(extra_.begin(), extra_.end(), std::uint64_t{0});
  row.rss_bytes = bytes_;
  row.tests_per_pair = tests_per_pair_;
  row.steps = static_cast<std::uint32_t>(each.size());
  return row;
}

}  // namespace kerf

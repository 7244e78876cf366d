#include "frames/report/meetings.h"

#include <algorithm>
#include <numeric>

#include "frames/bench/bench_row.h"

namespace kerf {

void Meetings::add(std::span<const Pair> truth, std::span<const Pair> reported) {
  next_.clear();
  auto old = open_.begin();
  auto heard = reported.begin();
  for (const Pair& pair : truth) {
    for (; old != open_.end() && old->pair < pair; ++old) end(*old);
    const bool is_old = old != open_.end() && old->pair == pair;
    next_.push_back(is_old ? *old++ : Meeting{pair, step_, step_ > 0});
    while (heard != reported.end() && *heard < pair) ++heard;
    if (heard != reported.end() && *heard == pair && next_.back().waits) detect(next_.back());
  }
  for (; old != open_.end(); ++old) end(*old);
  std::swap(open_, next_);
  ++step_;
}

void Meetings::detect(Meeting& meeting) {
  meeting.waits = false;
  lags_.push_back(static_cast<double>(step_ - meeting.begin));
}

void Meetings::end(const Meeting& meeting) {
  if (!meeting.waits) return;
  ++never_;
  lags_.push_back(static_cast<double>(step_ - meeting.begin));
}

Json Meetings::figures() const {
  Meetings ended = *this;
  for (const Meeting& meeting : open_) ended.end(meeting);
  return ended.figures_of_ended();
}

Json Meetings::figures_of_ended() const {
  std::vector<double> sorted = lags_;
  std::sort(sorted.begin(), sorted.end());
  const double all = std::max<double>(1, static_cast<double>(sorted.size()));
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  return {{"meetings", sorted.size()},
          {"never_share", static_cast<double>(never_) / all},
          {"lag_mean", sum / all},
          {"lag_p99", percentile(sorted, 0.99)},
          {"lag_max", percentile(sorted, 1)}};
}

}  // namespace kerf

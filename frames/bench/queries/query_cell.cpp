#include "frames/bench/queries/query_cell.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "frames/bench/queries/kerf_queries.h"
#include "frames/bench/queries/query_sets.h"

namespace kerf {
namespace {

/// Queries whose answers are compared with a scan.
constexpr std::size_t kScanned = 64;
/// How often structures are built, and how often their boxes move.
constexpr int kTurns = 5;
/// Queries between two looks at the clock.
constexpr std::uint32_t kBlock = 16;

template <class Work>
double nanoseconds(Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

template <int D>
class QueryCell {
 public:
  explicit QueryCell(const QueryPlan& plan)
      : plan_(plan), motion_(plan.scene->make<D>(plan.objects, plan.seed)) {
    for (std::uint32_t step = 0; step < plan.warm_up; ++step) motion_->advance();
  }

  std::vector<QueryRow> measure(const std::function<bool()>& goes_on) {
    std::vector<QueryRow> rows;
    rows.push_back(time_builds());
    rows.push_back(time_moves());
    for (auto& structure : structures_) structure->build(motion_->boxes());
    truth_.build(motion_->boxes());
    const QuerySets<D> sets(motion_->boxes(), plan_.queries, plan_.seed);
    for (const QueryKind<D>& kind : query_kinds<D>())
      if (goes_on()) rows.push_back(measure(kind, sets));
    return rows;
  }

 private:
  [[nodiscard]] QueryRow row(std::string_view kind) const {
    return {std::string(plan_.scene->name), D, plan_.objects, std::string(kind), 0, {}};
  }
  void make_structures() {
    structures_.clear();
    structures_.push_back(std::make_unique<KerfQueries<D>>());
    for (auto& rival : query_rivals<D>()) structures_.push_back(std::move(rival));
  }
  /// Each time of new structures. The first one of a process finds no memory and no code at hand.
  QueryRow time_builds() {
    std::vector<std::vector<double>> times;
    for (int k = 0; k < kTurns; ++k) {
      make_structures();
      take_turns(times, [&](QueryRival<D>& structure) { structure.build(motion_->boxes()); });
    }
    return row_of_turns("build", times);
  }
  /// Of some steps. Moving the boxes in our table is part of a step, not of the queries.
  QueryRow time_moves() {
    std::vector<std::vector<double>> times;
    for (int step = 0; step < kTurns; ++step) {
      motion_->advance();
      static_cast<KerfQueries<D>&>(*structures_.front()).prepare(motion_->boxes());
      take_turns(times, [&](QueryRival<D>& structure) { structure.move(motion_->boxes()); });
    }
    return row_of_turns("move", times);
  }
  /// Appends the nanoseconds an object that each structure takes.
  template <class Work>
  void take_turns(std::vector<std::vector<double>>& times, Work work) {
    times.resize(structures_.size());
    for (std::size_t k = 0; k < structures_.size(); ++k)
      times[k].push_back(nanoseconds([&] { work(*structures_[k]); }) / plan_.objects);
  }
  [[nodiscard]] QueryRow row_of_turns(std::string_view kind,
                                      const std::vector<std::vector<double>>& times) const {
    QueryRow result = row(kind);
    for (std::size_t k = 0; k < structures_.size(); ++k)
      result.times.push_back(
          {std::string(structures_[k]->name()), std::ranges::min(times[k]), median(times[k]), 0});
    return result;
  }
  QueryRow measure(const QueryKind<D>& kind, const QuerySets<D>& sets) {
    QueryRow result = row(kind.name);
    std::vector<QueryRival<D>*> able;
    for (auto& structure : structures_) {
      if (!kind.ask(*structure, sets, 0, 1, answer_)) continue;
      able.push_back(structure.get());
      result.times.push_back({std::string(structure->name()), 0, 0, 0});
    }
    for (std::uint32_t begin = 0; begin < plan_.queries; begin += kBlock)
      time_block(kind, sets, begin, std::min(begin + kBlock, plan_.queries), able, result);
    for (QueryTime& time : result.times) {
      time.least_ns /= plan_.queries;
      time.median_ns /= plan_.queries;
    }
    for (std::size_t query = 0; query < plan_.queries; ++query) compare(kind, sets, query, able, result);
    result.found /= plan_.queries;
    return result;
  }
  /// All structures have their turn with the same few queries, so that other work on the machine disturbs
  /// them alike, and some rounds not at all.
  void time_block(const QueryKind<D>& kind, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
                  const std::vector<QueryRival<D>*>& able, QueryRow& result) {
    std::vector<std::vector<double>> rounds(able.size());
    for (std::uint32_t round = 0; round < plan_.rounds; ++round)
      for (std::size_t k = 0; k < able.size(); ++k)
        rounds[k].push_back(nanoseconds([&] { kind.ask(*able[k], sets, begin, end, answer_); }));
    for (std::size_t k = 0; k < able.size(); ++k) {
      result.times[k].least_ns += std::ranges::min(rounds[k]);
      result.times[k].median_ns += median(rounds[k]);
    }
  }
  void compare(const QueryKind<D>& kind, const QuerySets<D>& sets, std::size_t query,
               const std::vector<QueryRival<D>*>& able, QueryRow& result) {
    Answer ours;
    kind.ask(*able.front(), sets, query, query + 1, ours);
    result.found += static_cast<double>(ours.size());
    const auto differs = [&](QueryRival<D>& structure) {
      Answer theirs;
      kind.ask(structure, sets, query, query + 1, theirs);
      return are_alike(kind.name, ours, theirs) ? 0U : 1U;
    };
    if (query < kScanned) result.times.front().differs += differs(truth_);
    for (std::size_t k = 1; k < able.size(); ++k) result.times[k].differs += differs(*able[k]);
  }

  QueryPlan plan_;
  std::unique_ptr<Motion<D>> motion_;
  std::vector<std::unique_ptr<QueryRival<D>>> structures_;
  ScanQueries<D> truth_;
  Answer answer_;
};

}  // namespace

std::optional<double> QueryRow::over_fastest() const {
  std::optional<double> least;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k].structure != "embree")
      least = std::min(least.value_or(times[k].least_ns), times[k].least_ns);
  return least ? std::optional(*least / times.front().least_ns) : std::nullopt;
}

std::optional<double> QueryRow::over_embree() const {
  const auto embree = std::ranges::find(times, "embree", &QueryTime::structure);
  return embree == times.end() ? std::nullopt : std::optional(embree->least_ns / times.front().least_ns);
}

template <int D>
std::vector<QueryRow> measure_queries(const QueryPlan& plan, const std::function<bool()>& goes_on) {
  return QueryCell<D>(plan).measure(goes_on);
}

template std::vector<QueryRow> measure_queries<2>(const QueryPlan&, const std::function<bool()>&);
template std::vector<QueryRow> measure_queries<3>(const QueryPlan&, const std::function<bool()>&);

}  // namespace kerf

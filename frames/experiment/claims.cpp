#include "frames/experiment/claims.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <span>

#include "frames/catalog/algorithm.h"

namespace kerf {
namespace {

constexpr std::string_view kBsp = kPaperTree;
constexpr std::string_view kQt = "ode-quadtree";
constexpr std::string_view kSh = "ode-hash";
constexpr std::string_view kLo = "loose-octree";
constexpr std::string_view kSp = "sweep-and-prune";

constexpr const char* kFlatOctree =
    "our loose octree is a few flat arrays, built anew in one pass and scanned at the speed of memory, where "
    "that of "
    "the paper chased nodes";
constexpr const char* kFlatQuadtree =
    "ODE's quadtree divides the XZ plane only, and each of its columns holds many objects one above the "
    "other, "
    "which are all compared; a structure that also separates heights has less to do";
constexpr const char* kFewSwaps =
    "ends swap where objects pass each other, and here most rest or move along: SP keeps its overlaps from "
    "step to "
    "step and has little to do";
constexpr const char* kHiddenWork =
    "ODE's hash space does its work in one call: only the handing over of boxes counts as its overhead here, "
    "the "
    "building of its table as collision time";
constexpr const char* kLongLists = "a tree of few leaves has long lists to sweep";
constexpr const char* kStayInLeaves =
    "most objects stay in their leaves, as one comparison shows; ODE looks for the block of every geom "
    "that moved";

std::string number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), x >= 100 ? "%.0f" : "%.3g", x);
  return text.data();
}

std::string short_name(std::string_view contestant) {
  if (contestant == kBsp) return "BSP";
  if (contestant == kQt) return "QT";
  if (contestant == kSh) return "SH";
  if (contestant == kLo) return "LO";
  return "SP";
}

using Measure = double (*)(const Means&);
double total(const Means& m) { return m.total(); }
double collision(const Means& m) { return m.collision; }
double update(const Means& m) { return m.update; }
double candidates(const Means& m) { return m.candidates; }

/// The means of a simulation.
class Judge {
 public:
  Judge(int simulation, const ExperimentRuns& runs)
      : simulation_(simulation), run_(runs[static_cast<std::size_t>(simulation - 1)]) {}

  [[nodiscard]] double of(Measure measure, std::string_view name, double begin = 0, double end = 1) const {
    return measure(means_of(run_, name, begin, end));
  }
  /// Whether `name` is the least of the five by that measure, but for `allowed` that may be less.
  [[nodiscard]] bool leads(Measure measure, std::string_view name, std::string_view allowed = {}) const {
    return std::ranges::all_of(std::array{kBsp, kQt, kSh, kLo, kSp}, [&](std::string_view other) {
      return other == name || other == allowed || of(measure, other) < 0 ||
             of(measure, name) <= of(measure, other);
    });
  }
  /// Whether `name` is the greatest of the five.
  [[nodiscard]] bool trails(Measure measure, std::string_view name) const {
    return std::ranges::all_of(std::array{kBsp, kQt, kSh, kLo, kSp}, [&](std::string_view other) {
      return of(measure, name) >= of(measure, other);
    });
  }
  [[nodiscard]] bool similar(Measure measure, std::string_view a, std::string_view b) const {
    const double ratio = of(measure, a) / of(measure, b);
    return ratio > 0.5 && ratio < 2;
  }
  /// "BSP 0.5, QT 0.7 ms" of all five, without those that have no figure.
  [[nodiscard]] std::string figures(Measure measure, const char* unit) const {
    std::string text;
    for (const std::string_view name : {kBsp, kQt, kSh, kLo, kSp})
      if (of(measure, name) >= 0)
        text += (text.empty() ? "" : ", ") + short_name(name) + " " + number(of(measure, name));
    return text + unit;
  }
  [[nodiscard]] std::string times(Measure measure) const { return figures(measure, " ms"); }
  [[nodiscard]] std::string pairs() const {
    const auto sum = [](double all, const ExperimentStep& row) {
      return all + static_cast<double>(row.pairs);
    };
    double all = 0;
    for (const ExperimentStep& row : run_) all = sum(all, row);
    return "candidates " + figures(candidates, "") + "; delivered by all " +
           number(all / static_cast<double>(run_.size()));
  }
  [[nodiscard]] ClaimVerdict verdict(const char* claim, bool holds, std::string figures,
                                     const std::string& reason) const {
    return {simulation_, claim, holds, std::move(figures), holds ? "" : reason};
  }
  [[nodiscard]] const ExperimentRun& run() const { return run_; }

 private:
  int simulation_;
  const ExperimentRun& run_;
};

void judge_terrain(const ExperimentRuns& runs, std::vector<ClaimVerdict>& verdicts) {
  const Judge judge(1, runs);
  verdicts.push_back(judge.verdict("BSP and LO lead in performance",
                                   judge.leads(total, kBsp, kLo) && judge.leads(total, kLo, kBsp),
                                   judge.times(total), kFewSwaps));
  verdicts.push_back(judge.verdict("LO generates more collision pairs",
                                   judge.of(candidates, kLo) > judge.of(candidates, kBsp), judge.pairs(),
                                   kLongLists));
  verdicts.push_back(judge.verdict(
      "SP generates fewer collision pairs at the expense of higher time",
      judge.of(candidates, kSp) < judge.of(candidates, kBsp) && judge.of(total, kSp) > judge.of(total, kBsp),
      judge.pairs() + "; " + judge.times(total), kFewSwaps));
  verdicts.push_back(judge.verdict("BSP has the best performance ratio for collision",
                                   judge.leads(collision, kBsp), "collision " + judge.times(collision),
                                   kFewSwaps));
  verdicts.push_back(judge.verdict("the BSP overhead is worse than QT",
                                   judge.of(update, kBsp) > judge.of(update, kQt),
                                   "overhead " + judge.times(update), kStayInLeaves));
  verdicts.push_back(judge.verdict(
      "the BSP overhead is similar to SP and LO",
      judge.similar(update, kBsp, kSp) && judge.similar(update, kBsp, kLo), "overhead " + judge.times(update),
      "SP renews and walks all its lists in each step, LO is built anew, the tree "
      "touches what moved"));
  verdicts.push_back(judge.verdict("the BSP overhead is better than SH",
                                   judge.of(update, kBsp) < judge.of(update, kSh),
                                   "overhead " + judge.times(update), kHiddenWork));
}

void judge_attractors(const ExperimentRuns& runs, std::vector<ClaimVerdict>& verdicts) {
  const Judge judge(2, runs);
  verdicts.push_back(judge.verdict("QT leads in performance, since it is suitable for sparse environments",
                                   judge.leads(total, kQt), judge.times(total), kFlatQuadtree));
  verdicts.push_back(judge.verdict("QT and BSP show similar results in time", judge.similar(total, kQt, kBsp),
                                   judge.times(total), kFlatQuadtree));
  verdicts.push_back(judge.verdict("QT has the best overhead, followed by BSP",
                                   judge.leads(update, kQt) && judge.leads(update, kBsp, kQt),
                                   "overhead " + judge.times(update), kFlatOctree));
  verdicts.push_back(
      judge.verdict("SP generates less pairs than any other method, but with a high cost",
                    judge.leads(candidates, kSp) && judge.of(total, kSp) > judge.of(total, kBsp),
                    judge.pairs() + "; " + judge.times(total), kFewSwaps));
}

/// Before and after the first fracture, where the number of objects begins to grow.
double first_fracture(const ExperimentRun& run) {
  const auto grown =
      std::ranges::find_if(run, [&](const ExperimentStep& row) { return row.moving > run.front().moving; });
  return static_cast<double>(grown - run.begin()) / static_cast<double>(run.size());
}

/// Reported pairs, over moving objects, between two parts of the run.
double pairs_of_an_object(const ExperimentRun& run, double begin, double end) {
  const auto first = static_cast<std::size_t>(begin * static_cast<double>(run.size()));
  const auto last = std::max(first + 1, static_cast<std::size_t>(end * static_cast<double>(run.size())));
  double pairs = 0;
  double objects = 0;
  for (std::size_t k = first; k < last; ++k) {
    pairs += static_cast<double>(run[k].pairs);
    objects += run[k].moving;
  }
  return pairs / objects;
}

void judge_fracture(const ExperimentRuns& runs, std::vector<ClaimVerdict>& verdicts) {
  const Judge judge(3, runs);
  const double broken = std::min(0.8, first_fracture(judge.run()) + 0.05);
  const double early = pairs_of_an_object(judge.run(), broken, broken + 0.1);
  const double late = pairs_of_an_object(judge.run(), 0.8, 1);
  verdicts.push_back(judge.verdict("collision pairs decrease after the fractures", late < early,
                                   "pairs for each object: " + number(early) +
                                       " when blocks have just broken, " + number(late) + " at the end",
                                   "the attractor keeps the fragments as near each other as they were"));
  verdicts.push_back(judge.verdict("SH and SP are not as fast as QT and BSP",
                                   std::max(judge.of(total, kQt), judge.of(total, kBsp)) <
                                       std::min(judge.of(total, kSh), judge.of(total, kSp)),
                                   judge.times(total), kFlatQuadtree));
  verdicts.push_back(judge.verdict("BSP has a small advantage in collision time compared to QT",
                                   judge.of(collision, kBsp) < judge.of(collision, kQt),
                                   "collision " + judge.times(collision), kLongLists));
  verdicts.push_back(judge.verdict("BSP has a higher overhead than QT",
                                   judge.of(update, kBsp) > judge.of(update, kQt),
                                   "overhead " + judge.times(update), kStayInLeaves));
  verdicts.push_back(judge.verdict("LO has the worst collision time", judge.trails(collision, kLo),
                                   "collision " + judge.times(collision), kFlatOctree));
}

void judge_buckets(const ExperimentRuns& runs, std::vector<ClaimVerdict>& verdicts) {
  const Judge judge(4, runs);
  verdicts.push_back(judge.verdict("BSP has the best collision time, followed by QT",
                                   judge.leads(collision, kBsp) && judge.leads(collision, kQt, kBsp),
                                   "collision " + judge.times(collision),
                                   std::string(kFlatQuadtree) + "; " + kFewSwaps));
  const auto growth = [&](std::string_view name) {
    return judge.of(total, name, 0.8, 1) / judge.of(total, name, 0.2, 0.4);
  };
  double others = 0;
  std::string figures =
      "time in the last fifth of the run over that in the second: SP " + number(growth(kSp));
  for (const std::string_view name : {kBsp, kQt, kSh, kLo}) {
    others = std::max(others, growth(name));
    figures += ", " + short_name(name) + " " + number(growth(name));
  }
  verdicts.push_back(judge.verdict("SP has the worst scaling", growth(kSp) > others, figures, kFewSwaps));
  verdicts.push_back(
      judge.verdict("SP has overhead times similar to BSP", judge.similar(update, kSp, kBsp),
                    "overhead " + judge.times(update),
                    "SP walks over all its lists in each step, whether anything moved or not"));
  verdicts.push_back(
      judge.verdict("LO has a better overhead time than BSP", judge.of(update, kLo) < judge.of(update, kBsp),
                    "overhead " + judge.times(update),
                    "our loose octree is built anew in each step, the tree touches only what moved"));
  verdicts.push_back(judge.verdict("SH has the worst time, as there is more than one object in a cell",
                                   judge.trails(total, kSh), judge.times(total), kFlatQuadtree));
  verdicts.push_back(judge.verdict("BSP finds the pairs in a much faster way than SH",
                                   judge.of(total, kBsp) < 0.5 * judge.of(total, kSh), judge.times(total),
                                   kLongLists));
}

/// Over the last two thirds of the runs, after which a tree has grown.
void judge_depth(const ExperimentRuns& runs, std::vector<ClaimVerdict>& verdicts) {
  const auto bsp = static_cast<std::size_t>(std::ranges::find(contestants(), kBsp) - contestants().begin());
  std::uint32_t worst = 0;
  std::string figures;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::uint32_t change = 0;
    for (std::size_t i = runs[k].size() / 3 + 10; i < runs[k].size(); ++i) {
      const std::uint32_t now = runs[k][i].contestants[bsp].height;
      const std::uint32_t before = runs[k][i - 10].contestants[bsp].height;
      change = std::max(change, now > before ? now - before : before - now);
    }
    worst = std::max(worst, change);
    figures += (k == 0 ? "" : ", ") + std::to_string(change);
  }
  verdicts.push_back({0, "BSP-tree depths do not suffer dramatic changes", worst <= 3,
                      "greatest change within ten steps, by simulation: " + figures,
                      worst <= 3 ? "" : "whole clouds leave their leaves at once here"});
}

/// Negative values do not count; -1 if there is no other.
double mean_of_medians(std::span<const ExperimentStep> run,
                       const std::function<double(const ExperimentStep&)>& value) {
  constexpr std::size_t kStretch = 20;
  double sum = 0;
  double count = 0;
  for (std::size_t begin = 0; begin < run.size(); begin += kStretch) {
    std::vector<double> values;
    for (const ExperimentStep& row : run.subspan(begin, std::min(kStretch, run.size() - begin)))
      if (value(row) >= 0) values.push_back(value(row));
    if (values.empty()) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    sum += *middle;
    ++count;
  }
  return count > 0 ? sum / count : -1;
}

}  // namespace

Means means_of(const ExperimentRun& run, std::string_view contestant, double begin, double end) {
  const auto k =
      static_cast<std::size_t>(std::ranges::find(contestants(), contestant) - contestants().begin());
  const auto first = static_cast<std::size_t>(begin * static_cast<double>(run.size()));
  const auto last = std::max(first + 1, static_cast<std::size_t>(end * static_cast<double>(run.size())));
  const auto mean = [&](const std::function<double(const ExperimentStep&)>& value) {
    return mean_of_medians(std::span(run).subspan(first, last - first), value);
  };
  return {mean([k](const ExperimentStep& row) { return row.fps(k); }),
          mean([k](const ExperimentStep& row) { return row.contestants[k].collision; }),
          mean([k](const ExperimentStep& row) { return row.contestants[k].update; }),
          mean([k](const ExperimentStep& row) { return row.contestants[k].candidates; })};
}

std::vector<ClaimVerdict> judge_claims(const ExperimentRuns& runs) {
  std::vector<ClaimVerdict> verdicts;
  judge_terrain(runs, verdicts);
  judge_attractors(runs, verdicts);
  judge_fracture(runs, verdicts);
  judge_buckets(runs, verdicts);
  judge_depth(runs, verdicts);
  return verdicts;
}

}  // namespace kerf

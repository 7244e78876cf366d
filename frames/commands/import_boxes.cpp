#include "frames/commands/import_boxes.h"

#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include "core/recording/recorder.h"
#include "core/replay/oracle.h"
#include "frames/support/csv_lines.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMostSteps = 10'000'000;
constexpr std::uint32_t kMostObjects = 10'000'000;

using PairsByStep = std::map<std::uint32_t, std::vector<Pair>>;

/// `first` is the first step of the boxes.
PairsByStep read_pairs(const std::filesystem::path& path, std::uint32_t first) {
  PairsByStep pairs;
  if (path.empty()) return pairs;
  CsvLines lines(path);
  while (lines.next()) {
    if (lines.columns() != 3) lines.reject("a pair has three columns: step,a,b");
    const std::uint32_t step = lines.whole(0, kMostSteps);
    if (step < first)
      lines.reject("step " + std::to_string(step) + " is before the first one of the boxes, step " +
                   std::to_string(first));
    const ObjectId a{lines.whole(1, kMostObjects)};
    const ObjectId b{lines.whole(2, kMostObjects)};
    if (a == b) lines.reject("an object makes no pair with itself");
    pairs[step].push_back(make_pair(a, b));
  }
  return pairs;
}

template <int D>
class Import {
 public:
  Import(const ImportRequest& request, PairsByStep pairs)
      : has_pairs_(!request.pairs.empty()),
        pairs_(std::move(pairs)),
        tree_(request.config),
        recorder_(tree_, request.out, info(request)) {}

  /// The lines stand at their first one.
  void run(CsvLines& lines) {
    do {
      const std::uint32_t step = lines.whole(0, kMostSteps);
      if (!step_) step_ = step;
      if (step < *step_)
        lines.reject("step " + std::to_string(step) + " comes after step " + std::to_string(*step_));
      while (*step_ < step) end_step();
      take(lines);
    } while (lines.next());
    const std::uint32_t last = pairs_.empty() ? 0 : pairs_.rbegin()->first;
    do end_step();
    while (*step_ <= last);
    recorder_.finish();
    print();
  }

 private:
  static RecordingInfo info(const ImportRequest& request) {
    RecordingInfo info;
    info.dimension = D;
    info.config = request.config;
    info.scene = request.boxes.filename().string();
    info.imported = true;
    return info;
  }

  void take(const CsvLines& lines) {
    constexpr std::size_t kColumns = 2 + 2 * D;
    if (lines.columns() != kColumns && lines.columns() != kColumns + 1)
      lines.reject("this line has " + std::to_string(lines.columns()) + " columns and the first had " +
                   std::to_string(kColumns));
    const ObjectId object{lines.whole(1, kMostObjects)};
    if (lines.is_empty(2)) {
      if (recorder_.remove(object) == Status::unknown_id)
        lines.reject("object " + std::to_string(object.value) + " goes, but is not there");
      return;
    }
    Box<D> box;
    for (int axis = 0; axis < D; ++axis) {
      box.min[axis] = lines.real(static_cast<std::size_t>(2 + 2 * axis));
      box.max[axis] = lines.real(static_cast<std::size_t>(3 + 2 * axis));
    }
    const bool fixed = lines.columns() > kColumns && lines.whole(kColumns, 1) == 1;
    if (recorder_.move(object, box) == Status::unknown_id)
      (void)recorder_.insert(object, box, fixed ? Mobility::fixed : Mobility::moving);
  }

  void end_step() {
    recorder_.step();
    (void)tree_.trace().take();
    if (has_pairs_) judge();
    ++*step_;
  }

  void judge() {
    const std::vector<Pair>& theirs = pairs_[*step_];
    const PairJudgement judgement = judge_pairs(theirs, oracle_pairs(tree_.objects()));
    recorder_.add_theirs(
        theirs, {theirs.size(), judgement.missed.size(), judgement.extra.size(), judgement.twice.size()});
    sum_.pairs += theirs.size();
    sum_.missed += judgement.missed.size();
    sum_.extra += judgement.extra.size();
    sum_.twice += judgement.twice.size();
    if (!judgement.is_exact() && first_wrong_ == 0) first_wrong_ = tree_.steps();
  }

  void print() const {
    std::printf("%u steps, %u objects\n", tree_.steps(), tree_.statistics().objects);
    if (!has_pairs_) return;
    const auto wide = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
    std::printf("the other engine reported %llu pairs: %llu missed, %llu extra, %llu twice\n",
                wide(sum_.pairs), wide(sum_.missed), wide(sum_.extra), wide(sum_.twice));
    if (first_wrong_ != 0) std::printf("first wrong in step %u\n", first_wrong_);
  }

  bool has_pairs_;
  PairsByStep pairs_;
  Bsp<D, EventLog> tree_;
  Recorder<D> recorder_;
  std::optional<std::uint32_t> step_;  ///< theirs, the one that is being read
  TheirStep sum_;
  std::uint32_t first_wrong_ = 0;  ///< ours
};

}  // namespace

void import_boxes(const ImportRequest& request) {
  CsvLines lines(request.boxes);
  if (!lines.next()) throw UsageError(request.boxes.string() + " has no boxes");
  PairsByStep pairs = read_pairs(request.pairs, lines.whole(0, kMostSteps));
  if (lines.columns() == 6 || lines.columns() == 7) {
    Import<2>(request, std::move(pairs)).run(lines);
  } else if (lines.columns() == 8 || lines.columns() == 9) {
    Import<3>(request, std::move(pairs)).run(lines);
  } else {
    lines.reject("a box has 6 columns in 2D and 8 in 3D, and perhaps one more, fixed");
  }
}

}  // namespace kerf

#include "frames/import/import_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/base/poll.h"
#include "core/recording/recorder.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "frames/import/import_progress.h"
#include "frames/import/shown_objects.h"
#include "frames/import/signed_ids.h"
#include "frames/import/step_lines.h"
#include "frames/import/their_nodes.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

template <int D>
GivenBox<D> box_of(const BoxLine& line) {
  GivenBox<D> box;
  std::copy_n(line.min.begin(), D, box.min.begin());
  std::copy_n(line.max.begin(), D, box.max.begin());
  return box;
}

/// What is read before the boxes are played.
struct Theirs {
  std::vector<GivenPairs> pairs;
  std::vector<GivenNodes> nodes;
};

/// What is known of an object while it is played.
template <int D>
struct Played {
  GivenBox<D> box;
  GivenFilter filter;
  GivenFilter recorded_filter;  ///< as of the last row
  bool is_there = false;
  bool fixed = false;
  bool has_given_box = false;  ///< the recording has a box in doubles of it
  bool changed_box = false;    ///< in this step
  bool comes = false;          ///< in this step

  /// A reader goes on from the last row, an export from the default if the object comes again.
  [[nodiscard]] bool needs_filter() const {
    return filter != recorded_filter || (comes && filter != GivenFilter{});
  }
};

template <int D>
class Import {
 public:
  Import(const ImportRequest& request, const Survey& survey, Theirs theirs, PairDesign design,
         ShownObjects<D> shown, Oddities& oddities)
      : request_(request),
        survey_(survey),
        pairs_(std::move(theirs.pairs)),
        nodes_(std::move(theirs.nodes), survey),
        oddities_(oddities),
        shown_(std::move(shown)),
        info_(info_of(request, survey, std::move(design), shown_.marks())),
        tree_(request.config),
        recorder_(tree_, request.out, info_) {
    if (shown_.has_shapes()) recorder_.show([this](ObjectId object) { return shown_.appearance(object); });
  }

  void run(BoxLines& boxes, ImportProgress& progress) {
    StepLines lines(boxes, survey_, request_.unite, oddities_);
    for (const GivenStep& step : survey_.steps) {
      progress.at("step " + step.text + ", " + std::to_string(tree_.steps() + 1) + " of " +
                  std::to_string(survey_.steps.size()));
      poll();
      for (const BoxLine& line : lines.next(step)) play(boxes, line, step);
      end_step(step);
    }
    lines.end();
    note_end_of_pairs();
    recorder_.finish();
  }

  [[nodiscard]] std::string text() const {
    return pairs_text() + (request_.structure.empty() ? "" : nodes_.text());
  }

 private:
  [[nodiscard]] std::string pairs_text() const {
    if (request_.pairs.empty()) return "";
    std::string text = "the other engine reported " + counted(sum_.pairs, "pair") + ": " +
                       std::to_string(sum_.missed) + " missed, " + std::to_string(sum_.extra) + " extra, " +
                       std::to_string(sum_.twice) + " twice, " + std::to_string(sum_.ignored) + " ignored";
    if (sum_.ignored > 0)
      text += " (" + count_text(PairVerdict::filtered) + " by filters, " + count_text(PairVerdict::listed) +
              " by the list, " + count_text(PairVerdict::margin) + " by the margin)";
    if (sum_.undecided > 0)
      text += ", " + std::to_string(sum_.undecided) + " undecided in the " + to_text(info_.design.rounding) +
              " that were written";
    text += "\n";
    if (!first_wrong_.empty()) text += "first wrong in step " + first_wrong_ + "\n";
    return text;
  }

  static RecordingInfo info_of(const ImportRequest& request, const Survey& survey, PairDesign design,
                               const ObjectMarks& marks) {
    RecordingInfo info;
    info.marks = marks;
    info.dimension = D;
    info.config = request.config;
    info.scene = request.boxes == "-" ? "standard input" : request.boxes.filename().string();
    info.imported = true;
    info.names = survey.names;
    info.design = std::move(design);
    info.digits = survey.digits;
    return info;
  }

  [[nodiscard]] std::string count_text(PairVerdict verdict) const {
    return std::to_string(verdicts_[static_cast<std::size_t>(verdict)]);
  }

  void play(const BoxLines& boxes, const BoxLine& line, const GivenStep& step) {
    const ObjectId object = survey_.object(line.object);
    if (played_.size() <= object.index()) played_.resize(object.index() + 1);
    Played<D>& played = played_[object.index()];
    const auto place = [&] { return boxes.table().name() + ", line " + std::to_string(line.line); };
    if (line.kind == BoxLine::Kind::removal) {
      if (!played.is_there)
        throw UsageError(place() + ": object " + to_string(line.object) + " goes, but is not there");
      (void)recorder_.remove(object);
      played.is_there = false;
      return;
    }
    if (!played.is_there) {
      played.filter = {};  // what was said of it before it went is over
      played.comes = true;
    }
    const bool fixed = line.fixed.value_or(played.is_there && played.fixed);
    if (played.is_there && fixed != played.fixed)
      oddities_.note(Oddity::mobility, [&] {
        return place() + ": object " + to_string(line.object) + " is " + (fixed ? "fixed" : "moving") +
               " from step " + step.text + " on";
      });
    ask(object, played, box_of<D>(line), fixed);
    if (!shown_.place(object, round_outward(played.box), line.turn))
      oddities_.note(Oddity::large_shape, [&] {
        return place() + ": object " + to_string(line.object) + " in step " + step.text;
      });
    note_change(object, played, line);
  }

  /// A tree's object keeps its mobility, so that one with another mobility is a new one.
  void ask(ObjectId object, Played<D>& played, const GivenBox<D>& box, bool fixed) {
    const Box<D> floats = round_outward(box);
    if (played.is_there && fixed != played.fixed) {
      (void)recorder_.remove(object);
      played.is_there = false;
    }
    if (played.is_there) {
      (void)recorder_.move(object, floats);
    } else if (recorder_.insert(object, floats, fixed ? Mobility::fixed : Mobility::moving) ==
               Status::sparse_id) {
      throw UsageError("object " + survey_.names.object(object) + ": more objects than a tree holds");
    }
    played.box = box;
    played.fixed = fixed;
    played.is_there = true;
  }

  void note_change(ObjectId object, Played<D>& played, const BoxLine& line) {
    if (!played.changed_box) changed_.push_back(object);
    played.changed_box = true;
    if (line.category) played.filter.category = *line.category;
    if (line.mask) played.filter.mask = *line.mask;
  }

  /// What is NaN has no other number in doubles.
  TheirChanges<D> take_changes() {
    TheirChanges<D> changes;
    std::ranges::sort(changed_);
    for (const ObjectId object : changed_) {
      Played<D>& played = played_[object.index()];
      const bool is_number = played.box == played.box;
      const bool differs = is_number && to_given(round_outward(played.box)) != played.box;
      if (differs || played.has_given_box)
        changes.boxes.push_back({object, differs ? std::optional(played.box) : std::nullopt});
      if (played.needs_filter()) changes.filters.push_back({object, played.filter});
      played.has_given_box = differs;
      played.recorded_filter = played.filter;
      played.changed_box = played.comes = false;
    }
    changed_.clear();
    return changes;
  }

  void end_step(const GivenStep& step) {
    recorder_.step();
    (void)tree_.trace().take();
    const TheirChanges<D> changes = take_changes();
    recorder_.add_theirs(changes);
    world_.apply(changes);
    if (!request_.pairs.empty()) judge(step);
    if (const auto structure = nodes_.take(step, tree_.objects())) recorder_.add_theirs(*structure);
  }

  void judge(const GivenStep& step) {
    std::vector<Pair> reported;
    const bool has_lines = next_pairs_ < pairs_.size() && pairs_[next_pairs_].step.time == step.time;
    if (has_lines)
      for (const GivenPair& pair : std::exchange(pairs_[next_pairs_++].pairs, {}))
        reported.push_back(reported_pair(pair, step));
    const auto judged =
        judge_theirs<D>(reported, oracle_pairs(tree_.objects()), tree_.objects(), world_, info_.design);
    recorder_.add_theirs(reported, judged);
    const TheirStep sum = sum_of(reported.size(), judged);
    sum_ += sum;
    for (const JudgedPair& one : judged) ++verdicts_[static_cast<std::size_t>(one.verdict)];
    if (sum.missed + sum.extra + sum.twice > 0 && first_wrong_.empty()) first_wrong_ = step.text;
    if (sum.missed > 0 && !has_lines) note_no_pairs(step);
    note_open_pairs(std::move(reported), judged, step);
  }

  /// A pair that was reported is right, whatever the digits.
  void note_open_pairs(std::vector<Pair> reported, const std::vector<JudgedPair>& judged,
                       const GivenStep& step) {
    const bool may_be_open = info_.design.rounding != BoundRounding{};
    if (may_be_open) {
      for (Pair& pair : reported) pair = make_pair(pair.a, pair.b);
      std::ranges::sort(reported);
    }
    for (const JudgedPair& one : judged) {
      poll();
      if (hangs_on_digits(one) && !(may_be_open && std::ranges::binary_search(reported, one.pair)))
        note_few_digits(one.pair, step);
    }
  }

  /// Whether the pair is undecided, or would be if the file had enough numbers to be sure how it was written.
  [[nodiscard]] bool hangs_on_digits(const JudgedPair& one) const {
    if (one.verdict == PairVerdict::undecided) return true;
    if (one.verdict != PairVerdict::missed) return false;
    const auto& objects = tree_.objects();
    const GivenBox<D> a = world_.box(objects, one.pair.a);
    const GivenBox<D> b = world_.box(objects, one.pair.b);
    const auto axis = undecided_axis(survey_.suspected, a, b);
    if (!axis) return false;
    const auto at = static_cast<std::size_t>(*axis);
    return std::abs(a.min[at] == b.max[at] ? a.min[at] : b.min[at]) >= survey_.suspected_from;
  }

  void note_few_digits(const Pair& pair, const GivenStep& step) {
    oddities_.note(Oddity::few_digits, [&] {
      return request_.pairs.string() + ": pair " + info_.names.pair(pair) + " in step " + step.text;
    });
  }

  /// Pairs that were written every few steps, or late, look like an engine that reports nothing meanwhile.
  void note_no_pairs(const GivenStep& step) {
    const bool is_at_end = pairs_.empty() || step.time > pairs_.back().step.time;
    misses_at_end_ |= is_at_end;
    if (!is_at_end)
      oddities_.note(Oddity::no_pairs, [&] { return request_.pairs.string() + ": step " + step.text; });
  }

  /// A table that was cut off looks like an engine that reports nothing any more.
  void note_end_of_pairs() {
    if (!misses_at_end_) return;
    oddities_.note(Oddity::pairs_end, [&] {
      const std::string name = request_.pairs.string();
      if (pairs_.empty()) return name + ": there is no pair at all";
      return name + ": pairs end in step " + pairs_.back().step.text + ", boxes in step " +
             survey_.steps.back().text;
    });
  }

  Pair reported_pair(const GivenPair& pair, const GivenStep& step) {
    for (const GivenId& id : {pair.a, pair.b})
      if (tree_.objects().state(survey_.object(id)) == ObjectState::absent)
        oddities_.note(Oddity::absent_object, [&] {
          return request_.pairs.string() + ", line " + std::to_string(pair.line) + ": object " +
                 to_string(id) + " in step " + step.text;
        });
    return make_pair(survey_.object(pair.a), survey_.object(pair.b));
  }

  const ImportRequest& request_;
  const Survey& survey_;
  std::vector<GivenPairs> pairs_;
  TheirNodes<D> nodes_;
  std::size_t next_pairs_ = 0;
  Oddities& oddities_;
  ShownObjects<D> shown_;
  RecordingInfo info_;
  Bsp<D, EventLog> tree_;
  Recorder<D> recorder_;
  std::vector<Played<D>> played_;
  std::vector<ObjectId> changed_;  ///< in this step
  TheirWorld<D> world_;
  TheirStep sum_;
  std::array<std::uint64_t, kVerdicts> verdicts_{};
  std::string first_wrong_;
  bool misses_at_end_ = false;  ///< after the last step that has pairs, if there is any
};

/// Objects that the run does not have make no pair in it.
PairDesign design_of(const ImportRequest& request, const Survey& survey, Oddities& oddities) {
  PairDesign design{request.margin, {}, survey.rounding};
  if (request.ignore.empty()) return design;
  for (const GivenPair& pair : read_ignored_pairs(request.ignore, oddities)) {
    for (const GivenId& id : {pair.a, pair.b})
      check_sign(id, survey.objects, request.ignore.string(), pair.line);
    const auto a = survey.find(pair.a);
    const auto b = survey.find(pair.b);
    if (a && b)
      design.ignored.push_back(make_pair(*a, *b));
    else
      oddities.note(Oddity::unknown_ignored, [&] {
        return request.ignore.string() + ", line " + std::to_string(pair.line) + ": object " +
               to_string(a ? pair.b : pair.a);
      });
  }
  std::ranges::sort(design.ignored);
  design.ignored.erase(std::unique(design.ignored.begin(), design.ignored.end()), design.ignored.end());
  return design;
}

std::string range_text(std::size_t count, const std::string& what, const std::string& first,
                       const std::string& last) {
  std::string text = counted(count, what);
  if (count == 0) return text;
  return text + " numbered " + first + (count == 1 ? "" : " to " + last);
}

std::string summary(const BoxLines& boxes, const Survey& survey) {
  return std::to_string(boxes.dimension()) + "D, " +
         range_text(survey.steps.size(), "step", survey.steps.front().text, survey.steps.back().text) + ", " +
         range_text(survey.objects.size(), "object",
                    survey.objects.empty() ? "" : to_string(survey.objects.front()),
                    survey.objects.empty() ? "" : to_string(survey.objects.back())) +
         ", columns " + boxes.columns() + "\n";
}

template <int D>
void import_in(const ImportRequest& request, ImportProgress& progress, BoxLines& boxes, const Survey& survey,
               Theirs theirs, Oddities& oddities) {
  std::vector<GivenObject<D>> given;
  if (!request.objects.empty()) given = read_given_objects<D>(request.objects, oddities);
  ShownObjects<D> shown(given, request.objects.string(), survey, oddities);
  Import<D> import(request, survey, std::move(theirs), design_of(request, survey, oddities), std::move(shown),
                   oddities);
  import.run(boxes, progress);
  if (request.strict && oddities.any())
    throw UsageError("--strict: what is odd is an error, and nothing was written\n" + oddities.text());
  progress.end();
  std::fputs((summary(boxes, survey) + oddities.text() + import.text()).c_str(), stdout);
}

}  // namespace

void import_boxes(const ImportRequest& request, const InterruptGuard& interrupt) {
  const std::array inputs{request.boxes, request.pairs, request.ignore, request.objects, request.structure};
  if (std::ranges::count(inputs, "-") > 1)
    throw UsageError("only one of the tables can come from standard input");
  if (request.unite && !request.structure.empty())
    throw UsageError(
        "--unite and --structure: an object of several boxes has several nodes, and none of them holds all; "
        "leave out one, or give each box an object of its own");
  ImportProgress progress(interrupt);
  BoxLines boxes(request.boxes);
  Theirs theirs;
  Oddities oddities;
  if (!request.pairs.empty()) theirs.pairs = read_given_pairs(request.pairs, oddities);
  GivenTrees trees;
  if (!request.structure.empty()) trees = read_given_nodes(request.structure, boxes.dimension(), oddities);
  const Survey found =
      survey(boxes, theirs.pairs, request.pairs.string(), trees, request.structure.string(), oddities);
  theirs.nodes = std::move(trees.steps);
  if (boxes.dimension() == 2) {
    import_in<2>(request, progress, boxes, found, std::move(theirs), oddities);
  } else {
    import_in<3>(request, progress, boxes, found, std::move(theirs), oddities);
  }
}

}  // namespace kerf

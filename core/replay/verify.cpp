#include "core/replay/verify.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <vector>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/number_text.h"
#include "core/base/poll.h"
#include "core/bsp/state_codec.h"
#include "core/recording/shape_rows.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/replay/replayer.h"
#include "core/scene/pose_in_box.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

/// One figure of a step, as text.
struct Figure {
  std::string name;
  std::string recorded;
  std::string replayed;
};

/// All figures of a step's row that come from the tree, without the times.
std::vector<Figure> figures_of(const StepRow& row, const Statistics& now, std::uint64_t pairs) {
  const Statistics& then = row.statistics;
  std::vector<Figure> figures;
  const auto add = [&](const std::string& name, auto recorded, auto replayed) {
    figures.push_back({name, std::to_string(recorded), std::to_string(replayed)});
  };
  add("objects", then.objects, now.objects);
  add("pairs", row.pairs, pairs);
  add("height", then.height, now.height);
  add("leaves", then.leaves, now.leaves);
  add("entries", then.entries, now.entries);
  figures.push_back({"redundancy", exact_number(then.redundancy), exact_number(now.redundancy)});
  for (int op = 0; op < kOperatorCount; ++op)
    add(std::string(to_string(static_cast<Operator>(op))) + " operators",
        then.count(static_cast<Operator>(op)), now.count(static_cast<Operator>(op)));
  add("refused", then.refused, now.refused);
  add("deferred", then.deferred, now.deferred);
  add("placed", then.placed, now.placed);
  return figures;
}

template <int D>
class Verifier {
 public:
  Verifier(const std::filesystem::path& path, std::uint32_t oracle_every)
      : recording_(RecordingReader<D>::open_changed(path)),
        replayer_(recording_),
        resumed_(recording_->info().config, recording_->info().volume),
        oracle_every_(oracle_every) {
    resumed_.decide(recording_->info().decisions);
  }

  Verdict run(const std::function<bool(std::uint32_t)>& progress) {
    const Polling polling([&] {
      if (progress && !progress(verdict_.steps + 1)) throw Stopped();
    });
    try {
      check_all();
    } catch (const Stopped&) {
    }
    say_what_was_left();
    return verdict_;
  }

 private:
  void check_all() {
    verdict_.names = recording_->info().names;
    recording_->check_pages();
    verdict_.change = recording_->change();
    if (!verdict_.change) verdict_.change = recording_->added();
    verdict_.shapes = count_shapes<D>(recording_->shapes());
    operators_ = recording_->operators();
    for (std::uint32_t step = 1; step <= recording_->steps() && !verdict_.divergence; ++step) {
      poll();
      replay(step);
    }
  }

  void replay(std::uint32_t step) {
    std::vector<Event> events;
    replayer_.advance([&](const Event& event) { events.push_back(event); });
    compare_events(step, events);
    if (!verdict_.divergence) compare_operators(step, events);
    if (!verdict_.divergence) compare_figures(step);
    if (!verdict_.divergence) compare_hashes(step, replayer_.tree(), "");
    if (!verdict_.divergence) check_looks(step);
    if (!verdict_.divergence) go_on_from_keyframe(step);
    if (recording_->info().imported) follow_their_boxes(step);
    judge(step);
    ++verdict_.steps;
    verdict_.events += events.size();
    verdict_.pairs += replayer_.tree().pairs().size();
  }

  void diverge(std::uint32_t step, std::string recorded, std::string replayed,
               std::optional<std::uint64_t> event = std::nullopt) {
    if (!verdict_.divergence) verdict_.divergence = {step, event, std::move(recorded), std::move(replayed)};
  }

  void compare_events(std::uint32_t step, const std::vector<Event>& replayed) {
    const std::vector<Event>& recorded = recording_->step(step).events;
    for (std::size_t k = 0; k < std::max(recorded.size(), replayed.size()); ++k) {
      if (k < recorded.size() && k < replayed.size() && recorded[k] == replayed[k]) continue;
      return diverge(step, name(recorded, k), name(replayed, k), recording_->row(step).first_event + k);
    }
  }

  [[nodiscard]] std::string name(const std::vector<Event>& events, std::size_t k) const {
    if (k >= events.size()) return "no further event";
    std::string text = describe(events[k], verdict_.names);
    if (const auto* const acted = acted_of(events[k]))
      text += " along direction " + std::to_string(acted->direction) + " from " +
              std::to_string(acted->old_offset) + " to " + std::to_string(acted->new_offset);
    return text;
  }

  /// Compares the table of events, which is a copy for SQL.
  void compare_operators(std::uint32_t step, const std::vector<Event>& replayed) {
    for (const Event& event : replayed) {
      const auto row = operator_row(event);
      if (!row) continue;
      const bool is_same = next_operator_ < operators_.size() && operators_[next_operator_] == *row;
      if (!is_same)
        return diverge(step, "another row in the table of events, or none", describe(event, verdict_.names),
                       event.id);
      ++next_operator_;
    }
    if (next_operator_ < operators_.size() && operators_[next_operator_].step == step)
      diverge(step, "one more row in the table of events", "no further event",
              operators_[next_operator_].event);
  }

  void compare_figures(std::uint32_t step) {
    const Bsp<D, Watch>& tree = replayer_.tree();
    for (const Figure& figure : figures_of(recording_->row(step), tree.statistics(), tree.pairs().size()))
      if (figure.recorded != figure.replayed)
        diverge(step, figure.name + " " + figure.recorded, figure.replayed);
  }

  void compare_hashes(std::uint32_t step, const Bsp<D, Watch>& tree, const std::string& how) {
    const StepRow& row = recording_->row(step);
    if (row.state_hash != tree.state_hash())
      diverge(step, "state hash " + to_hex(row.state_hash), to_hex(tree.state_hash()) + how);
    else if (row.pairs_hash != hash_pairs(tree.pairs()))
      diverge(step, counted(row.pairs, "pair"),
              counted(tree.pairs().size(), "pair") + ", not the same" + how);
  }

  /// A seek continues from a keyframe: the following steps must be those of the recording, too.
  void go_on_from_keyframe(std::uint32_t step) {
    if (verdict_.keyframes > 0) {
      run_recorded_step(*recording_, resumed_);
      compare_hashes(step, resumed_, ", when gone on from the keyframe before");
    }
    if (verdict_.divergence || !recording_->has_keyframe(step)) return;
    const BspState<D> keyframe = recording_->keyframe(step, replayer_.tree().tree().projector());
    if (encode_state(keyframe) != encode_state(replayer_.tree().state()))
      return diverge(step, "a keyframe of another state",
                     "state hash " + to_hex(replayer_.tree().state_hash()));
    resumed_.restore(keyframe);
    ++verdict_.keyframes;
  }

  /// Every object's shape is in its box, and the looks at a keyframe are those that the steps before have led
  /// to.
  void check_looks(std::uint32_t step) {
    const RecordedStep<D>& recorded = recording_->step(step);
    looks_.apply(recorded.looks);
    const ObjectTable<D>& objects = replayer_.tree().objects();
    for (const ObjectId object : recorded.requests.objects)
      if (objects.is_placed(object) && !is_in_box(looks_.of(object), objects.box(object)))
        return diverge(step, "a shape",
                       "a box that is too small for it, of object " + verdict_.names.object(object));
    if (recording_->has_keyframe(step) && recording_->keyframe_looks(step) != looks_)
      diverge(step, "a keyframe with other shapes or rotations", "those of the steps before");
  }

  [[nodiscard]] bool is_in_box(const Look<D>& look, const Box<D>& box) const {
    if (look.shape == kNoShape) return true;
    const Shape<D> shape = stretched<D>(recording_->shapes()[look.shape], look.stretch);
    return pose_in_box<D>(shape, axes_of(look.turn), box).has_value();
  }

  void judge(std::uint32_t step) {
    std::vector<Pair> truth;
    const bool asks = oracle_every_ != 0 && step % oracle_every_ == 0;
    if (asks) truth = oracle_pairs(replayer_.tree().objects());
    recording_->check_theirs(step);
    if (const auto judged = recording_->their_step(step)) {
      judge_theirs(step, *judged, asks ? &truth : nullptr);
      last_judged_ = step;
    }
    if (asks) judge_ours(step, truth);
  }

  void judge_ours(std::uint32_t step, const std::vector<Pair>& truth) {
    const PairJudgement judgement = judge_pairs(replayer_.tree().pairs(), truth);
    if (!judgement.is_exact() && verdict_.first_wrong_step == 0) verdict_.first_wrong_step = step;
    ++verdict_.judged;
    verdict_.missed += judgement.missed.size();
    verdict_.extra += judgement.extra.size();
    verdict_.twice += judgement.twice.size();
  }

  void judge_theirs(std::uint32_t step, const TheirStep& recorded, const std::vector<Pair>* truth) {
    const std::vector<Pair> reported = recording_->their_pairs(step);
    if (reported.size() != recorded.pairs)
      diverge(step, counted(recorded.pairs, "pair") + " of theirs", std::to_string(reported.size()));
    if (truth != nullptr) compare_verdicts(step, reported, *truth, recorded);
    verdict_.theirs += recorded;  // nothing of a step that is given up
  }

  /// How their pairs were judged is judged again.
  void compare_verdicts(std::uint32_t step, const std::vector<Pair>& reported, const std::vector<Pair>& truth,
                        const TheirStep& recorded) {
    const auto judged =
        kerf::judge_theirs<D>(reported, truth, replayer_.tree().objects(), world_, recording_->info().design);
    const std::vector<JudgedPair> before = recording_->judged_pairs(step);
    if (judged == before && sum_of(reported.size(), judged) == recorded) return;
    diverge(step, counted(before.size(), "verdict") + " on their pairs",
            counted(judged.size(), "verdict") + ", not the same");
  }

  /// What was given in doubles is rounded outward to what the tree was asked.
  void follow_their_boxes(std::uint32_t step) {
    const TheirChanges<D> changes = recording_->their_changes(step);
    world_.apply(changes);
    const ObjectTable<D>& objects = replayer_.tree().objects();
    for (const auto& [object, box] : changes.boxes) {
      if (!box || verdict_.divergence || !objects.is_placed(object)) continue;
      if (round_outward(*box) != objects.box(object))
        diverge(step, "another box in doubles",
                "the box in floats of object " + verdict_.names.object(object));
    }
  }

  void say_what_was_left() {
    const std::uint32_t steps = recording_->steps();
    const auto say = [this](const std::string& what) { verdict_.unchecked.push_back(what); };
    say("how long phases took: no replay shows that");
    if (!verdict_.shapes.empty()) say("how objects are turned: no replay shows that");
    if (verdict_.steps < steps) say(verdict_.names.steps(verdict_.steps + 1, steps));
    if (verdict_.judged < verdict_.steps)
      say("the pairs of " + std::to_string(verdict_.steps - verdict_.judged) + " of " +
          counted(verdict_.steps, "step") + " by the oracle");
    if (recording_->info().complete) return;
    if (last_judged_ > 0 && last_judged_ < verdict_.steps)
      say("the other engine's pairs of step " + verdict_.names.step(verdict_.steps) +
          ": they are not in the recording");
    say("what came after step " + verdict_.names.step(steps) + ": the recording was not ended in order");
  }

  std::shared_ptr<RecordingReader<D>> recording_;
  Replayer<D> replayer_;
  Bsp<D, Watch> resumed_;  ///< from the last keyframe on; undefined before the first
  std::vector<OperatorRow> operators_;
  std::size_t next_operator_ = 0;
  std::uint32_t oracle_every_;
  TheirWorld<D> world_;
  Looks<D> looks_;
  Verdict verdict_;
  std::uint32_t last_judged_ = 0;  ///< of whose pairs of another engine the recording has a verdict
};

}  // namespace

std::string why_unjudged(const Verdict& verdict, std::uint32_t oracle_every) {
  if (oracle_every <= verdict.steps || verdict.steps == 0 || !verdict.holds()) return "";
  return "of " + counted(verdict.steps, "step") +
         " the oracle was asked in none, so whether the pairs are exact is not known; give a number up to "
         "that, or 0 if you do not want to know";
}

Verdict verify(const std::filesystem::path& path, std::uint32_t oracle_every,
               const std::function<bool(std::uint32_t)>& progress) {
  const DefaultFloats floats;
  if (read_recording_info(path).dimension == 2) return Verifier<2>(path, oracle_every).run(progress);
  return Verifier<3>(path, oracle_every).run(progress);
}

}  // namespace kerf

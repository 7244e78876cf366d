#include "core/replay/verify.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/replay/replayer.h"

namespace kerf {
namespace {

template <int D>
class Verifier {
 public:
  Verifier(const std::filesystem::path& path, std::uint32_t oracle_every)
      : recording_(std::make_shared<RecordingReader<D>>(path)),
        replayer_(recording_),
        oracle_every_(oracle_every) {}

  Verdict run(const std::function<bool(std::uint32_t)>& progress) {
    for (std::uint32_t step = 1; step <= recording_->steps() && !verdict_.divergence; ++step) {
      if (progress && !progress(step)) break;
      replay(step);
    }
    return verdict_;
  }

 private:
  void replay(std::uint32_t step) {
    std::vector<Event> events;
    replayer_.advance([&](const Event& event) { events.push_back(event); });
    ++verdict_.steps;
    verdict_.events += events.size();
    verdict_.pairs += replayer_.tree().pairs().size();
    compare_events(step, events);
    if (!verdict_.divergence) compare_state(step);
    if (!verdict_.divergence && std::ranges::binary_search(recording_->keyframes(), step))
      compare_keyframe(step);
    if (recording_->info().imported) follow_their_boxes(step);
    if (oracle_every_ != 0 && step % oracle_every_ == 0) ask_oracle(step);
    if (const auto theirs = recording_->their_step(step)) verdict_.theirs += *theirs;
  }

  void compare_events(std::uint32_t step, const std::vector<Event>& replayed) {
    const std::vector<Event>& recorded = recording_->step(step).events;
    for (std::size_t k = 0; k < std::max(recorded.size(), replayed.size()); ++k) {
      if (k < recorded.size() && k < replayed.size() && recorded[k] == replayed[k]) continue;
      verdict_.divergence = {step, recording_->row(step).first_event + k, name(recorded, k),
                             name(replayed, k)};
      return;
    }
  }

  static std::string name(const std::vector<Event>& events, std::size_t k) {
    if (k >= events.size()) return "no further event";
    std::string text = describe(events[k]);
    if (const auto* acted = std::get_if<OperatorActed>(&events[k].body))
      text += " along direction " + std::to_string(acted->direction) + " from " +
              std::to_string(acted->old_offset) + " to " + std::to_string(acted->new_offset);
    return text;
  }

  void compare_state(std::uint32_t step) {
    const StepRow& row = recording_->row(step);
    const Bsp<D, Watch>& tree = replayer_.tree();
    if (row.state_hash != tree.state_hash())
      verdict_.divergence = {step, std::nullopt, "state hash " + to_hex(row.state_hash),
                             to_hex(tree.state_hash())};
    else if (row.pairs_hash != hash_pairs(tree.pairs()))
      verdict_.divergence = {step, std::nullopt, std::to_string(row.pairs) + " pairs",
                             std::to_string(tree.pairs().size()) + " pairs, not the same"};
  }

  void compare_keyframe(std::uint32_t step) {
    ++verdict_.keyframes;
    const BspState<D> keyframe = recording_->keyframe(step, replayer_.tree().tree().projector());
    const std::uint64_t hash = keyframe.hash();
    if (hash == recording_->row(step).state_hash && keyframe.step == step) return;
    verdict_.divergence = {step, std::nullopt, "keyframe with state hash " + to_hex(hash),
                           to_hex(recording_->row(step).state_hash)};
  }

  void ask_oracle(std::uint32_t step) {
    const std::vector<Pair> truth = oracle_pairs(replayer_.tree().objects());
    const PairJudgement judgement = judge_pairs(replayer_.tree().pairs(), truth);
    if (!judgement.is_exact() && verdict_.first_wrong_step == 0) verdict_.first_wrong_step = step;
    verdict_.missed += judgement.missed.size();
    verdict_.extra += judgement.extra.size();
    verdict_.twice += judgement.twice.size();
    if (!verdict_.divergence && recording_->their_step(step)) compare_verdicts(step, truth);
  }

  /// What was given in doubles is rounded outward to what the tree was asked.
  void follow_their_boxes(std::uint32_t step) {
    const TheirChanges<D> changes = recording_->their_changes(step);
    world_.apply(changes);
    const ObjectTable<D>& objects = replayer_.tree().objects();
    for (const auto& [object, box] : changes.boxes) {
      if (!box || verdict_.divergence || !objects.is_placed(object)) continue;
      if (round_outward(*box) != objects.box(object))
        verdict_.divergence = {step, std::nullopt, "another box in doubles",
                               "the box in floats of object " + recording_->info().names.object(object)};
    }
  }

  /// How their pairs were judged is judged again.
  void compare_verdicts(std::uint32_t step, std::span<const Pair> truth) {
    const std::vector<Pair> told = recording_->their_pairs(step);
    const auto judged =
        judge_theirs<D>(told, truth, replayer_.tree().objects(), world_, recording_->info().design);
    const std::vector<JudgedPair> recorded = recording_->judged_pairs(step);
    const TheirStep sum = sum_of(told.size(), judged);
    if (judged == recorded && sum == recording_->their_step(step)) return;
    verdict_.divergence = {step, std::nullopt, std::to_string(recorded.size()) + " verdicts on their pairs",
                           std::to_string(judged.size()) + " verdicts, not the same"};
  }

  std::shared_ptr<RecordingReader<D>> recording_;
  Replayer<D> replayer_;
  std::uint32_t oracle_every_;
  TheirWorld<D> world_;
  Verdict verdict_;
};

}  // namespace

Verdict verify(const std::filesystem::path& path, std::uint32_t oracle_every,
               const std::function<bool(std::uint32_t)>& progress) {
  if (read_recording_info(path).dimension == 2) return Verifier<2>(path, oracle_every).run(progress);
  return Verifier<3>(path, oracle_every).run(progress);
}

}  // namespace kerf

#include "viz/debugger/model/run_of.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/overloaded.h"
#include "core/query/criteria_text.h"
#include "core/query/explain_event.h"
#include "core/query/explain_node.h"
#include "core/query/explain_pair.h"
#include "core/query/explain_their_search.h"
#include "core/query/text.h"
#include "core/replay/what_if.h"
#include "core/trace/event_facts.h"
#include "core/tree/criteria.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf {
namespace {

/// Calls `visit` with each object below a node, those on both sides of a partitioner more than once.
template <int D, class Visit>
void for_each_object_below(const Tree<D>& tree, NodeId id, Visit visit) {
  for_each_node(tree, id, [&](NodeId below) {
    for (const Entry& entry : tree[below].entries) visit(entry.object);
  });
}

}  // namespace

template <int D>
RunOf<D>::RunOf(std::filesystem::path path)
    : path_(std::move(path)),
      recording_(std::make_shared<RecordingReader<D>>(path_)),
      cursor_(recording_),
      looks_(*recording_),
      search_(recording_),
      their_steps_(recording_->their_steps()),
      has_their_structure_(!recording_->structure_steps().empty()) {}

template <int D>
void RunOf<D>::moved() {
  tree_.assign(nullptr);
  ballot_.reset();
  judgement_.reset();
  hash_.reset();
  strip_of_.reset();
  answer_.reset();
}

template <int D>
std::uint64_t RunOf<D>::state_hash() const {
  if (!hash_) hash_ = state().hash();
  return *hash_;
}

template <int D>
void RunOf<D>::go(const Position& position) {
  if (position == cursor_.position()) return;
  cursor_.go(position);
  moved();
}

template <int D>
bool RunOf<D>::step(Granularity granularity, bool forwards) {
  const Position before = position();
  const bool went = forwards ? cursor_.forward(granularity) : cursor_.backward(granularity);
  if (before != position()) moved();
  return went;
}

template <int D>
std::span<const Event> RunOf<D>::events_of(std::uint32_t step) const {
  if (step == 0 || step > steps()) return {};
  return recording_->step(step).events;
}

template <int D>
const TreeSnapshotOf<D>& RunOf<D>::tree() {
  if (tree_.empty()) tree_.assign(&state().tree);
  return tree_;
}

template <int D>
std::vector<PairFigures> RunOf<D>::pair_figures() {
  return find_pair_figures(state(), cursor_.replayer(), ended_step());
}

template <int D>
ObjectCourse RunOf<D>::course(ObjectId object, const Progress& progress) {
  return find_course(*recording_, object, progress);
}

/// Tables of objects never shrink.
template <int D>
bool RunOf<D>::knows(ObjectId object) {
  if (!ids_) {
    cursor_.replayer().seek(steps());
    ids_ = cursor_.replayer().tree().objects().bound();
  }
  return object.index() < *ids_;
}

template <int D>
const std::vector<CandidateRow>& RunOf<D>::ballot() {
  if (ballot_) return *ballot_;
  ballot_.emplace();
  for (const BallotEntry& entry : cursor_.candidates()) {
    const Plane<D> plane{state().tree.directions()[entry.direction], entry.offset};
    ballot_->push_back({entry, plane_text(plane), double{score(entry.quality)}});
  }
  return *ballot_;
}

template <int D>
std::vector<Body<D>> RunOf<D>::bodies() {
  return recorded_bodies<D>(state().latest, {looks_.at(position().step), recording_->shapes(), info().marks});
}

template <int D>
Plane<D> RunOf<D>::plane(std::size_t candidate) {
  const BallotEntry& entry = ballot()[candidate].entry;
  return {state().tree.directions()[entry.direction], entry.offset};
}

template <int D>
std::optional<NodeId> RunOf<D>::event_node() const {
  const auto event = cursor_.event();
  const auto ref = event ? node_of(*event) : std::nullopt;
  return ref ? std::optional(ref->node) : std::nullopt;
}

template <int D>
const ProjectionStrip& RunOf<D>::strip(std::size_t candidate) {
  if (strip_of_ != candidate) strip_ = make_strip(candidate);
  strip_of_ = candidate;
  return strip_;
}

template <int D>
ProjectionStrip RunOf<D>::make_strip(std::size_t candidate) {
  ProjectionStrip strip;
  const auto node = event_node();
  const Tree<D>& tree = state().tree;
  if (!node || candidate >= ballot().size() || !this->tree().is_alive(*node)) return strip;
  const BallotEntry& entry = ballot()[candidate].entry;
  std::vector<ObjectId> objects;
  for_each_object_below(tree, *node, [&](ObjectId object) { objects.push_back(object); });
  std::ranges::sort(objects);
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  for (const ObjectId object : objects) strip.intervals.push_back(tree.project(entry.direction, object));
  std::ranges::sort(strip.intervals, {}, &Interval::lo);
  strip.offset = double{entry.offset};
  return strip;
}

template <int D>
std::string RunOf<D>::explain(const Selection& selection) {
  return std::visit(
      Overloaded{
          [](std::monostate) { return std::string(); },
          [&](NodeId node) { return to_text(explain_node(*recording_, position(), state(), node), names()); },
          [&](ObjectId object) { return explain_object(object); },
          [&](const Pair& pair) { return explain_pair(pair); },
      },
      selection);
}

template <int D>
std::string RunOf<D>::explain_object(ObjectId object) const {
  const ObjectTable<D>& table = state().latest;
  std::string text = title(object);
  if (table.state(object) == ObjectState::absent) return text + " is not there\n";
  if (table.state(object) == ObjectState::quarantined)
    return text + " has a box that cannot be placed: it is in quarantine\n";
  text += std::string(table.is_fixed(object) ? " is fixed" : " moves") + "\n  " +
          box_text(table.box(object)) + "\nit is stored in";
  for (const NodeId leaf : leaves_of(object)) text += " " + node_text(leaf);
  std::size_t count = 0;
  std::string others;
  for (const Pair& pair : pairs()) {
    if (pair.a != object && pair.b != object) continue;
    ++count;
    others += " " + names().object(pair.a == object ? pair.b : pair.a);
  }
  return text + "\nits pairs" + note_on_pairs() + ": " +
         (count == 0 ? "none" : std::to_string(count) + ", with" + others) + "\n";
}

template <int D>
std::string RunOf<D>::explain_pair(const Pair& pair) {
  std::string text = to_text(kerf::explain_pair(cursor_.replayer(), position().step, pair), info());
  const TheirStructure<D>& structure = theirs();
  if (!knows_theirs_) return text;
  cursor_.replayer().seek(ended_step());
  return text + explain_their_search<D>(structure, cursor_.replayer().tree().objects(), pair, names());
}

template <int D>
const TheirStructure<D>& RunOf<D>::theirs() {
  if (theirs_of_ == ended_step()) return theirs_;
  theirs_of_ = ended_step();
  auto structure = recording_->their_structure(*theirs_of_);
  knows_theirs_ = structure.has_value();
  theirs_ = knows_theirs_ ? std::move(*structure) : TheirStructure<D>();
  their_parts_.reset();
  their_faults_.reset();
  return theirs_;
}

template <int D>
const StructureParts<D>& RunOf<D>::their_parts() {
  const TheirStructure<D>& structure = theirs();
  if (!their_parts_) their_parts_ = parts_of(structure).parts;
  return *their_parts_;
}

template <int D>
std::span<const StructureFault> RunOf<D>::their_faults() {
  const TheirStructure<D>& structure = theirs();
  if (!knows_theirs_) return {};
  if (!their_faults_) {
    cursor_.replayer().seek(ended_step());
    const ObjectTable<D>& table = cursor_.replayer().tree().objects();
    const std::vector<std::uint32_t> known = recording_->structure_steps();
    const auto found = std::ranges::lower_bound(known, ended_step());
    TheirStructure<D> before;
    TheirPast<D> past;
    if (found != known.begin()) {
      before = recording_->their_structure(found[-1]).value_or(TheirStructure<D>());
      past = {&before, found[-1] + 1 == ended_step(), holds_fixed(before, table)};
    }
    their_faults_ = check_theirs<D>(structure, table, names(), past);
  }
  return *their_faults_;
}

template <int D>
std::span<const TheirFault> RunOf<D>::all_their_faults() {
  if (!all_their_faults_) all_their_faults_ = find_their_faults<D>(cursor_.replayer(), {});
  return *all_their_faults_;
}

template <int D>
std::string RunOf<D>::explain_event(std::uint64_t event) {
  return to_text(kerf::explain_event(cursor_.replayer(), event), names());
}

template <int D>
const QueryExplanation<D>* RunOf<D>::answer(const std::string& query) {
  if (answer_ && answer_->first == query) return &answer_->second;
  try {
    answer_.emplace(query, kerf::explain_query(state().tree, state().latest, parse_query<D>(query)));
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
  answer_->second.at = position();
  return &answer_->second;
}

template <int D>
std::string RunOf<D>::explain_query(const std::string& query) {
  if (const QueryExplanation<D>* const known = answer(query)) return to_text(*known, names());
  static_cast<void>(parse_query<D>(query));  // says what is wrong with it
  return "";
}

template <int D>
std::string RunOf<D>::wish(NodeId node) const {
  return wish_text(state().tree, node, state().config, names());
}

template <int D>
std::vector<NodeId> RunOf<D>::leaves_of(ObjectId object) const {
  std::vector<NodeId> leaves;
  const Tree<D>& tree = state().tree;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (std::ranges::find(tree[id].entries, object, &Entry::object) != tree[id].entries.end())
      leaves.push_back(id);
  });
  return leaves;
}

template <int D>
std::vector<Event> RunOf<D>::history(NodeId node) {
  return node_history(*recording_, node, recording_->steps());
}

template <int D>
std::span<const NodeLife> RunOf<D>::lives(NodeId node) {
  if (!lives_) lives_ = find_node_lives(operators());
  return node.index() < lives_->size() ? std::span<const NodeLife>((*lives_)[node.index()])
                                       : std::span<const NodeLife>();
}

template <int D>
std::vector<PairChange> RunOf<D>::history(const Pair& pair) {
  return pair_history(*recording_, pair, recording_->steps());
}

template <int D>
const std::vector<OperatorRow>& RunOf<D>::operators() {
  if (!operators_) operators_ = read_operators(path_);
  return *operators_;
}

template <int D>
void RunOf<D>::rerun(const WhatIfQuestion& question, const std::filesystem::path& out,
                     const Progress& progress) {
  RecordingInfo changed = recording_->info();
  if (question.event) decide(changed, cursor_.replayer(), *question.event, question.candidate);
  if (!question.assignments.empty()) {
    Config wanted = config_of(changed, question.from);
    kerf::apply(wanted, question.assignments);
    change_config(changed, *recording_, question.from, wanted);
  }
  std::uint32_t step = 0;
  (void)kerf::rerun(*recording_, changed, out, [&] { return progress && !progress(++step); });
}

template <int D>
RecordingComparison RunOf<D>::compare(Run& other) {
  return std::visit(
      [&]<int OtherD>(RunOf<OtherD>* run) -> RecordingComparison {
        if constexpr (OtherD == D) return kerf::compare(*recording_, *run->recording_);
        throw std::runtime_error("a run in 2D and one in 3D cannot be compared");
      },
      other.self());
}

template <int D>
const TreeSnapshotOf<D>& RunOf<D>::tree_before(std::uint64_t event) {
  if (before_of_ == event) return before_;
  const BspState<D> state = state_before(cursor_.replayer(), event);
  before_.assign(&state.tree);
  before_of_ = event;
  return before_;
}

template <int D>
const PairJudgement& RunOf<D>::judgement() {
  if (judgement_) return *judgement_;
  const std::uint32_t step = position().step;
  if (const auto theirs = step > 0 ? recording_->their_step(step) : std::nullopt) {
    judged_pairs_ = theirs->pairs;
    judgement_ = by_verdict(recording_->judged_pairs(step));
    return *judgement_;
  }
  cursor_.replayer().seek(step);
  const auto& tree = cursor_.replayer().tree();
  judged_pairs_ = tree.pairs().size();
  judgement_ = judge_pairs(tree.pairs(), oracle_pairs(tree.objects()));
  return *judgement_;
}

template <int D>
std::uint64_t RunOf<D>::judged_pairs() {
  (void)judgement();
  return judged_pairs_;
}

template <int D>
const PairJudgement* RunOf<D>::their_judgement() {
  const auto step_of = [](const auto& item) { return item.first; };
  return std::ranges::binary_search(their_steps_, position().step, {}, step_of) ? &judgement() : nullptr;
}

template <int D>
const std::vector<WrongPair>& RunOf<D>::wrong_pairs() {
  if (!wrong_pairs_) wrong_pairs_ = find_wrong_pairs(*recording_);
  return *wrong_pairs_;
}

template <int D>
std::optional<Position> RunOf<D>::search(const Expression& condition, const Position& from, bool forwards,
                                         const Progress& progress) {
  return forwards ? search_.forward(condition, from, progress) : search_.backward(condition, from, progress);
}

template <int D>
std::optional<Position> RunOf<D>::search_change(const Expression& expression, const Position& from,
                                                Change change, bool forwards, const Progress& progress) {
  return forwards ? search_.forward_change(expression, from, change, progress)
                  : search_.backward_change(expression, from, change, progress);
}

template class RunOf<2>;
template class RunOf<3>;

std::unique_ptr<Run> open_run(const std::filesystem::path& path) {
  if (read_recording_info(path).dimension == 2) return std::make_unique<RunOf<2>>(path);
  return std::make_unique<RunOf<3>>(path);
}

}  // namespace kerf

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/query/explain_query.h"
#include "core/query/search.h"
#include "core/query/their_parts.h"
#include "core/replay/cursor.h"
#include "core/replay/recorded_looks.h"
#include "viz/debugger/model/run.h"

namespace kerf {

/// A run of one dimension.
template <int D>
class RunOf final : public Run {
 public:
  explicit RunOf(std::filesystem::path path);

  [[nodiscard]] RunOfEitherDimension self() override { return this; }
  [[nodiscard]] const std::filesystem::path& path() const override { return path_; }
  [[nodiscard]] const RecordingInfo& info() const override { return recording_->info(); }
  [[nodiscard]] std::span<const StepRow> rows() const override { return recording_->rows(); }
  [[nodiscard]] const Position& position() const override { return cursor_.position(); }
  [[nodiscard]] std::optional<Event> event() const override { return cursor_.event(); }
  void go(const Position& position) override;
  bool step(Granularity granularity, bool forwards) override;
  [[nodiscard]] std::optional<std::size_t> candidate() const override { return cursor_.candidate(); }
  [[nodiscard]] std::optional<std::uint32_t> step_of(std::uint64_t event) const override {
    return recording_->step_of(event);
  }
  [[nodiscard]] std::span<const Event> events_of_step() const override { return events_of(position().step); }
  [[nodiscard]] std::span<const Event> events_of(std::uint32_t step) const override;
  [[nodiscard]] std::uint64_t state_hash() const override;
  [[nodiscard]] const Config& config() const override { return state().config; }
  [[nodiscard]] const TreeSnapshotOf<D>& tree() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return state().pairs; }
  [[nodiscard]] std::vector<PairFigures> pair_figures() override;
  [[nodiscard]] std::vector<ObjectFigures> object_figures() const override {
    return find_object_figures(state());
  }
  [[nodiscard]] ObjectCourse course(ObjectId object, const Progress& progress) override;
  [[nodiscard]] std::uint32_t objects() const override { return state().latest.size(); }
  [[nodiscard]] bool has(ObjectId object) const override { return state().latest.is_placed(object); }
  [[nodiscard]] bool knows(ObjectId object) override;
  [[nodiscard]] std::uint32_t deferred() const override { return state().scheduler.pending(); }
  [[nodiscard]] const std::vector<CandidateRow>& ballot() override;
  [[nodiscard]] std::optional<NodeId> event_node() const override;
  [[nodiscard]] const ProjectionStrip& strip(std::size_t candidate) override;
  [[nodiscard]] std::string explain(const Selection& selection) override;
  [[nodiscard]] std::string explain_event(std::uint64_t event) override;
  [[nodiscard]] std::string explain_query(const std::string& query) override;
  [[nodiscard]] std::string wish(NodeId node) const override;
  [[nodiscard]] std::vector<NodeId> leaves_of(ObjectId object) const override;
  [[nodiscard]] std::vector<Event> history(NodeId node) override;
  [[nodiscard]] std::span<const NodeLife> lives(NodeId node) override;
  [[nodiscard]] std::vector<PairChange> history(const Pair& pair) override;
  [[nodiscard]] const std::vector<OperatorRow>& operators() override;
  [[nodiscard]] std::vector<Thrash> lint(std::uint32_t within) override {
    return find_thrash(operators(), steps(), within);
  }
  void rerun(const WhatIfQuestion& question, const std::filesystem::path& out,
             const Progress& progress) override;
  [[nodiscard]] RecordingComparison compare(Run& other) override;
  [[nodiscard]] const TreeSnapshotOf<D>& tree_before(std::uint64_t event) override;
  [[nodiscard]] const PairJudgement& judgement() override;
  [[nodiscard]] std::uint64_t judged_pairs() override;
  [[nodiscard]] std::span<const std::pair<std::uint32_t, TheirStep>> their_steps() const override {
    return their_steps_;
  }
  [[nodiscard]] const PairJudgement* their_judgement() override;
  [[nodiscard]] const std::vector<WrongPair>& wrong_pairs() override;
  [[nodiscard]] bool has_their_structure() const override { return has_their_structure_; }
  [[nodiscard]] std::size_t their_nodes() override { return theirs().nodes.size(); }
  [[nodiscard]] std::span<const StructureFault> their_faults() override;
  [[nodiscard]] std::span<const TheirFault> all_their_faults() override;
  [[nodiscard]] std::optional<Position> search(const Expression& condition, const Position& from,
                                               bool forwards, const Progress& progress) override;
  [[nodiscard]] std::optional<Position> search_change(const Expression& expression, const Position& from,
                                                      Change change, bool forwards,
                                                      const Progress& progress) override;
  void check(const Expression& expression) override { search_.check(expression); }
  [[nodiscard]] ConditionNumber value(const Expression& expression) override {
    return search_.value(expression, position());
  }

  /// The complete state of the tree, for the view.
  [[nodiscard]] const BspState<D>& state() const { return cursor_.state(); }
  /// The objects as they look at this moment.
  [[nodiscard]] std::vector<Body<D>> bodies();
  /// Another engine's structure after the step that has ended last; without cells if it is not known.
  [[nodiscard]] const StructureParts<D>& their_parts();
  /// How the tree answers a query, see `parse_query`; null if that is none. Valid until it moves or another
  /// is asked.
  [[nodiscard]] const QueryExplanation<D>* answer(const std::string& query);
  /// The plane of a candidate of the ballot.
  [[nodiscard]] Plane<D> plane(std::size_t candidate);

 private:
  void moved();
  [[nodiscard]] ProjectionStrip make_strip(std::size_t candidate);
  [[nodiscard]] std::string explain_object(ObjectId object) const;
  [[nodiscard]] std::string explain_pair(const Pair& pair);
  [[nodiscard]] const TheirStructure<D>& theirs();

  std::filesystem::path path_;
  std::shared_ptr<RecordingReader<D>> recording_;
  Cursor<D> cursor_;
  RecordedLooks<D> looks_;
  Search<D> search_;

  // Computed at the first use, dropped when the cursor moves.
  TreeSnapshotOf<D> tree_;
  std::optional<std::vector<CandidateRow>> ballot_;
  std::optional<std::pair<std::string, QueryExplanation<D>>> answer_;
  std::optional<PairJudgement> judgement_;
  std::uint64_t judged_pairs_ = 0;
  mutable std::optional<std::uint64_t> hash_;
  std::optional<std::size_t> strip_of_;
  ProjectionStrip strip_;
  std::optional<std::size_t> ids_;                     ///< of objects, of the whole run
  std::optional<std::vector<OperatorRow>> operators_;  ///< the same
  std::optional<std::vector<std::vector<NodeLife>>> lives_;
  std::vector<std::pair<std::uint32_t, TheirStep>> their_steps_;
  std::optional<std::vector<WrongPair>> wrong_pairs_;
  bool has_their_structure_ = false;
  std::optional<std::uint32_t> theirs_of_;  ///< the step of the next four
  TheirStructure<D> theirs_;
  bool knows_theirs_ = false;
  std::optional<StructureParts<D>> their_parts_;
  std::optional<std::vector<StructureFault>> their_faults_;
  std::optional<std::vector<TheirFault>> all_their_faults_;
  TreeSnapshotOf<D> before_;
  std::optional<std::uint64_t> before_of_;  ///< the event of `before_`
};

}  // namespace kerf

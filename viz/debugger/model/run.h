#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/query/compare.h"
#include "core/query/expression.h"
#include "core/query/history.h"
#include "core/query/node_lives.h"
#include "core/query/search.h"
#include "core/query/their_faults.h"
#include "core/query/thrash.h"
#include "core/recording/operator_rows.h"
#include "core/recording/recording_info.h"
#include "core/replay/oracle.h"
#include "core/replay/position.h"
#include "core/tree/ballot.h"
#include "core/tree/tree_snapshot.h"
#include "viz/debugger/model/object_course.h"
#include "viz/debugger/model/selection.h"
#include "viz/debugger/model/state_figures.h"
#include "viz/debugger/model/wrong_pairs.h"

namespace kerf {

/// A candidate of the ballot in words and figures.
struct CandidateRow {
  BallotEntry entry;
  std::string plane;  ///< "0.6 x + 0.8 y = 3.5"
  double score = 0;
};

/// The objects of a node on a candidate's direction, by their lower ends, and where the candidate divides.
struct ProjectionStrip {
  std::vector<Interval> intervals;
  double offset = 0;
};

/// A change for a rerun: an operator is refused or takes another candidate, or parameters change from a step
/// on.
struct WhatIfQuestion {
  std::optional<std::uint64_t> event{};
  std::optional<std::size_t> candidate{};  ///< of the event's ballot; none: it is refused
  std::string assignments{};               ///< "K=V,..."; empty: no parameter changes
  std::uint32_t from = 1;                  ///< first step with them
};

template <int D>
class RunOf;
using RunOfEitherDimension = std::variant<RunOf<2>*, RunOf<3>*>;

/// A recorded run with a position in it, of any dimension: panels get their data here. Everything throws
/// std::runtime_error if the recording is damaged.
class Run {
 public:
  using Progress = std::function<bool(std::uint32_t)>;

  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  virtual ~Run() = default;
  /// The run by its dimension.
  [[nodiscard]] virtual RunOfEitherDimension self() = 0;

  [[nodiscard]] virtual const std::filesystem::path& path() const = 0;
  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
  /// One row for each step, the first being step 1.
  [[nodiscard]] virtual std::span<const StepRow> rows() const = 0;
  [[nodiscard]] const GivenNames& names() const { return info().names; }
  /// As `to_string`, with the label of an object if it has one: "object 5 left wheel".
  [[nodiscard]] std::string title(const Selection& thing) const {
    const std::string name = to_string(thing, names());
    const auto object = object_in(thing);
    return object ? info().marks.title(*object, name) : name;
  }
  [[nodiscard]] std::uint32_t steps() const { return static_cast<std::uint32_t>(rows().size()); }

  [[nodiscard]] virtual const Position& position() const = 0;
  /// The step that has ended last: pairs and another engine's structure are still of it within the next.
  [[nodiscard]] std::uint32_t ended_step() const {
    return position().is_end() ? position().step : position().step - 1;
  }
  /// " of step 49", of pairs, within step 50; empty at the end of a step.
  [[nodiscard]] std::string note_on_pairs() const {
    return position().is_end() ? "" : " of step " + names().step(ended_step());
  }
  /// The event that has just happened; none at the end of a step.
  [[nodiscard]] virtual std::optional<Event> event() const = 0;
  /// Does nothing if it is there already.
  virtual void go(const Position& position) = 0;
  /// False if there is nothing further in that direction.
  virtual bool step(Granularity granularity, bool forwards) = 0;
  /// The present candidate; none unless the run was stepped by candidates.
  [[nodiscard]] virtual std::optional<std::size_t> candidate() const = 0;
  [[nodiscard]] virtual std::optional<std::uint32_t> step_of(std::uint64_t event) const = 0;
  /// The events of the present step; none before the first. Valid until it moves.
  [[nodiscard]] virtual std::span<const Event> events_of_step() const = 0;
  /// The events of any step. Valid until it moves or another step is read.
  [[nodiscard]] virtual std::span<const Event> events_of(std::uint32_t step) const = 0;
  [[nodiscard]] virtual std::uint64_t state_hash() const = 0;
  /// The configuration at this moment.
  [[nodiscard]] virtual const Config& config() const = 0;

  /// The tree's nodes at this moment. Valid until it moves.
  [[nodiscard]] virtual const TreeSnapshot& tree() = 0;
  [[nodiscard]] virtual std::span<const Pair> pairs() const = 0;
  /// Of each of the pairs.
  [[nodiscard]] virtual std::vector<PairFigures> pair_figures() = 0;
  /// Of each object that is there.
  [[nodiscard]] virtual std::vector<ObjectFigures> object_figures() const = 0;
  /// See `find_course`.
  [[nodiscard]] virtual ObjectCourse course(ObjectId object, const Progress& progress) = 0;
  [[nodiscard]] virtual std::uint32_t objects() const = 0;
  /// Whether an object is there at this moment.
  [[nodiscard]] virtual bool has(ObjectId object) const = 0;
  /// Whether the id of an object is among those of the whole run.
  [[nodiscard]] virtual bool knows(ObjectId object) = 0;
  [[nodiscard]] virtual std::uint32_t deferred() const = 0;

  [[nodiscard]] virtual const std::vector<CandidateRow>& ballot() = 0;
  /// The node of the event that has just happened; none if it has none.
  [[nodiscard]] virtual std::optional<NodeId> event_node() const = 0;
  [[nodiscard]] virtual const ProjectionStrip& strip(std::size_t candidate) = 0;

  /// Sentences, a line each. Says so if the selection no longer exists.
  [[nodiscard]] virtual std::string explain(const Selection& selection) = 0;
  [[nodiscard]] virtual std::string explain_event(std::uint64_t event) = 0;
  /// How the tree at this moment answers a query, see `parse_query`. Throws std::invalid_argument for what is
  /// none.
  [[nodiscard]] virtual std::string explain_query(const std::string& query) = 0;
  /// What Algorithm 1 would do with a living node, with the figures.
  [[nodiscard]] virtual std::string wish(NodeId node) const = 0;
  [[nodiscard]] virtual std::vector<NodeId> leaves_of(ObjectId object) const = 0;
  [[nodiscard]] virtual std::vector<Event> history(NodeId node) = 0;
  /// The lives of a slot of nodes in the whole run, in order; none if it was never used.
  [[nodiscard]] virtual std::span<const NodeLife> lives(NodeId node) = 0;
  [[nodiscard]] virtual std::vector<PairChange> history(const Pair& pair) = 0;
  /// All that were listed, acted or were refused in the whole run, in order.
  [[nodiscard]] virtual const std::vector<OperatorRow>& operators() = 0;
  /// The places where operators undo each other or wait, in the whole run.
  [[nodiscard]] virtual std::vector<Thrash> lint(std::uint32_t within) = 0;
  /// Runs the same requests again, with another decision, and records that. Throws std::invalid_argument,
  /// with the reason, for an impossible decision.
  virtual void rerun(const WhatIfQuestion& question, const std::filesystem::path& out,
                     const Progress& progress) = 0;
  /// Throws std::runtime_error unless both have the same dimension.
  [[nodiscard]] virtual RecordingComparison compare(Run& other) = 0;
  /// The tree just before an event. Valid until another event is asked for. Throws std::runtime_error if the
  /// recording does not have it.
  [[nodiscard]] virtual const TreeSnapshot& tree_before(std::uint64_t event) = 0;

  /// The tree's pairs (in an import those of the other engine) compared with brute force, at the end of the
  /// step.
  [[nodiscard]] virtual const PairJudgement& judgement() = 0;
  [[nodiscard]] virtual std::uint64_t judged_pairs() = 0;
  /// Another engine's pairs in figures, of all steps, as an import has them; none of other runs.
  [[nodiscard]] virtual std::span<const std::pair<std::uint32_t, TheirStep>> their_steps() const = 0;
  /// Whether it is an import with another engine's pairs.
  [[nodiscard]] bool has_theirs() const { return !their_steps().empty(); }
  /// What the other engine got wrong in this step; null if the recording has no verdicts on it.
  [[nodiscard]] virtual const PairJudgement* their_judgement() = 0;
  /// Those of them that are wrong, see `find_wrong_pairs`. Read at the first use.
  [[nodiscard]] virtual const std::vector<WrongPair>& wrong_pairs() = 0;

  /// Whether it is an import with another engine's structure, and how many nodes that has after the step that
  /// has ended last; 0: it is not known.
  [[nodiscard]] virtual bool has_their_structure() const = 0;
  [[nodiscard]] virtual std::size_t their_nodes() = 0;
  /// What is wrong with it then.
  [[nodiscard]] virtual std::span<const StructureFault> their_faults() = 0;
  /// The same of all steps. Searched for at the first use.
  [[nodiscard]] virtual std::span<const TheirFault> all_their_faults() = 0;

  /// The next moment, in either direction, at which the condition holds; none if there is none or `progress`,
  /// called with each step, has returned false.
  [[nodiscard]] virtual std::optional<Position> search(const Expression& condition, const Position& from,
                                                       bool forwards, const Progress& progress) = 0;
  /// The same for moments at which its value changes.
  [[nodiscard]] virtual std::optional<Position> search_change(const Expression& expression,
                                                              const Position& from, Change change,
                                                              bool forwards, const Progress& progress) = 0;
  /// Throws std::invalid_argument for an expression that the run cannot answer; so do the three others.
  virtual void check(const Expression& expression) = 0;
  /// The value of an expression at this moment; NaN if it does not exist.
  [[nodiscard]] virtual ConditionNumber value(const Expression& expression) = 0;
};

/// Opens a recording of either dimension. Throws std::runtime_error that says why it cannot be read.
std::unique_ptr<Run> open_run(const std::filesystem::path& path);

}  // namespace kerf

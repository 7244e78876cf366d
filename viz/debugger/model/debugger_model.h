#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/query/counterpart.h"
#include "viz/debugger/model/breakpoint.h"
#include "viz/debugger/model/lanes.h"
#include "viz/debugger/model/ribbons.h"
#include "viz/debugger/model/run.h"
#include "viz/debugger/model/timeline.h"
#include "viz/debugger/model/view_settings.h"
#include "viz/debugger/model/wrong_pairs.h"

namespace kerf {

/// Steps of a scene in a second of its own time (paper section 6.2).
inline constexpr double kStepsOfScene = 25;

/// The complete state and behaviour of the debugger, without a window: panels and scripts only call it.
class DebuggerModel {
 public:
  explicit DebuggerModel(std::unique_ptr<Run> run);

  [[nodiscard]] Run& run() { return *run_; }
  [[nodiscard]] const Run& run() const { return *run_; }
  /// Those of the run, then those of the selected object, if they are shown.
  [[nodiscard]] const std::vector<Lane>& lanes() const { return lanes_; }

  // Going.
  void go(const Position& position);
  void go_to_event(std::uint64_t event);
  void step(Granularity wanted, bool forwards);
  /// To the next moment, either way, at which a breakpoint holds or a watched value makes its change;
  /// says so if there is none.
  void run_to_breakpoint(bool forwards);
  /// To the next moment, either way, at which the condition holds; says so if there is none. Throws
  /// std::invalid_argument that says what is wrong with it.
  void go_to_condition(const std::string& condition, bool forwards);
  /// To the next moment of that kind, either way, and chooses the kind; says so if there is none.
  void go_to_kind(EventKind kind, bool forwards);
  /// Plays on by so many seconds, if it is playing.
  void pass_time(double seconds);
  /// The seconds until it goes on; infinity if it does not play.
  [[nodiscard]] double seconds_to_next() const;

  /// To the end of a step at which the tree has grown, see opening.h.
  void go_to_opening();

  bool playing = false;
  double speed = kStepsOfScene;               ///< steps or events a second
  Granularity granularity = Granularity::op;  ///< the unit of `,` and `.`
  Granularity plays_by = Granularity::step;   ///< the unit of playing

  // Selecting.
  void select(const Selection& selection);
  /// With one object selected, another one makes a pair.
  void select_object(ObjectId object, bool makes_pair);
  [[nodiscard]] const Selection& selection() const { return selection_; }
  [[nodiscard]] bool is_selected(NodeId node) const;
  /// Shows the selected object's lanes: the leaves that hold it, its pairs, its speed. In a run that is short
  /// enough a selection does so by itself.
  void show_object_lanes();
  /// The lives of the selected node and its operators, or the times when the selected pair was one, or when
  /// the object with lanes was there: in the whole run, the lowest first.
  [[nodiscard]] const std::vector<Ribbon>& ribbons();
  /// Those that can be seen, see `thin_out`. Kept until the scale or the selection changes.
  [[nodiscard]] const std::vector<Ribbon>& shown_ribbons(const TimeScale& scale);

  // Seeing.
  ViewSettings view;
  Timeline timeline;
  /// Magnifies the lanes by a factor around the present moment, or around their middle if it is not seen.
  void zoom_lanes(double factor);
  /// Lets the selected range begin or end at the step of this moment.
  void begin_range();
  void end_range();
  void drop_range();
  /// Plays in the selected range over and over, or no longer.
  void toggle_loop();
  /// Shows the selected range; the whole run if there is none, or it is what is shown.
  void show_range();
  /// Moves the cursor to the greatest or least value of the chosen lane.
  void go_to_extreme(bool greatest);
  /// Hides the selected node or object; shows it again if it was hidden.
  void toggle_hidden();
  void show_all();
  /// Shows only the part below the selected node; everything if it was isolated.
  void toggle_isolated();
  /// Asks the tree a query, such as "ray 0,2,1,0": it is drawn, and explained while nothing is selected.
  /// Throws std::invalid_argument for what is none.
  void ask(const std::string& query);
  /// Selects nothing; if nothing is selected, forgets the query.
  void deselect();
  std::optional<std::size_t> hovered_candidate;  ///< of the ballot: its plane is drawn
  std::optional<NodeId> hovered_node;            ///< under the mouse in a panel: marked in the others, too

  // Stopping.
  /// Throws std::invalid_argument that says what is wrong with the condition.
  void add_breakpoint(const std::string& condition);
  void add_watch(const std::string& expression);
  void remove_breakpoint(std::size_t k);
  void remove_watch(std::size_t k);
  /// Makes the run stop at such a change of the watched value; none: it does not stop.
  void stop_at_watch(std::size_t k, std::optional<Change> change);
  /// Adds a breakpoint at the event that has just happened, or removes it.
  void toggle_breakpoint_here();
  std::vector<Breakpoint> breakpoints;
  [[nodiscard]] const std::vector<WatchedValue>& watches() const { return watches_; }

  // Marking.
  void toggle_bookmark();
  std::map<Position, std::string> bookmarks;  ///< and the note of each, which may be empty

  // Judging.
  /// Asks the oracle about the step of the cursor.
  const Alarm& ask_oracle();
  /// By step; only of those that were asked about, in an import of all whose pairs were judged.
  [[nodiscard]] const std::map<std::uint32_t, Alarm>& alarms() const { return alarms_; }
  [[nodiscard]] const std::set<std::uint32_t>& wrong_steps() const { return wrong_steps_; }
  /// Whether the oracle is asked at each step of the cursor; off where brute force would take too long.
  bool asks_oracle = true;
  /// The number of the wrong pair of the run that is selected in its step; none if there is no such one.
  [[nodiscard]] std::optional<std::size_t> wrong_pair();
  /// To the step of a wrong pair of the run, and selects it.
  void go_to_wrong_pair(std::size_t k);
  /// To the next or the previous one; without another engine's pairs to a wrong step that was asked about.
  /// Says so, and returns false, if there is none.
  bool go_to_error(bool forwards);

  // Comparing: another run follows this one, also within a step as far as it does the same.
  void compare_with(std::unique_ptr<Run> other);
  void stop_comparing();
  /// Called with each step of a search or a rerun; returns false to end it.
  Run::Progress on_long_work;
  /// Runs it again with another decision, into `work_folder`, and compares. Throws as Run::rerun.
  void what_if(const WhatIfQuestion& question);
  std::filesystem::path work_folder = ".";
  /// Continues in the other run, at the moment of this one; this one becomes the other.
  void change_over();
  /// Only while comparing.
  [[nodiscard]] const RecordingComparison& comparison();
  /// Moves both to the first operator that acted or was refused differently; says so if there is none.
  void go_to_first_different_operator();
  [[nodiscard]] Run* other() { return other_.get(); }
  /// How the moment of the other run corresponds to that of this one.
  [[nodiscard]] Counterpart::Match match() const { return match_; }
  [[nodiscard]] const std::vector<Lane>& other_lanes() const { return other_lanes_; }

  /// The places where operators undo each other or wait.
  [[nodiscard]] const std::vector<Thrash>& lint(std::uint32_t within);

  std::string message;  ///< the last message for the user
  bool message_is_error = false;

 private:
  std::string count_hit(const Stop& stop);
  [[nodiscard]] std::optional<Position> find_kind(EventKind kind, bool forwards,
                                                  const Run::Progress& progress);
  [[nodiscard]] Run::Progress noticing(bool& ended) const;
  void moved();
  void play_on();
  [[nodiscard]] std::optional<std::uint32_t> step_of_range();
  void take_verdicts();
  void add_node_ribbons(NodeId node);
  void add_pair_ribbons(const Pair& pair);
  void add_object_ribbons();
  void drop_object_lanes();
  void follow();
  void say(std::string text, bool is_error = false);

  std::unique_ptr<Run> run_;
  std::vector<Lane> lanes_;
  std::unique_ptr<Run> other_;
  std::vector<Lane> other_lanes_;
  Counterpart::Match match_ = Counterpart::Match::none;
  std::optional<RecordingComparison> comparison_;
  std::optional<std::vector<Thrash>> findings_;
  std::uint32_t findings_within_ = 0;
  Selection selection_;
  std::optional<std::vector<Ribbon>> ribbons_;  ///< of the selection
  std::optional<std::vector<Ribbon>> shown_ribbons_;
  TimeScale shown_scale_;
  std::vector<WatchedValue> watches_;
  std::map<std::uint32_t, Alarm> alarms_;
  std::set<std::uint32_t> wrong_steps_;
  WrongPairWalk walk_;
  int reruns_ = 0;
  double due_ = 0;  ///< the fraction of a step or event that playing has not reached yet
};

}  // namespace kerf

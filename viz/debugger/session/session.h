#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viz/debugger/model/debugger_model.h"
#include "viz/debugger/model/view_settings.h"

namespace kerf {

/// What distinguishes a recording from others: a hash of what happened in its steps, not of their times.
struct RecordingMark {
  std::string scene;
  int dimension = 3;
  std::uint32_t steps = 0;
  std::string hash;  ///< of these steps, in hexadecimal digits
  friend bool operator==(const RecordingMark&, const RecordingMark&) = default;
};

/// What a user did in the debugger, apart from going to and fro: everything that a file keeps of it.
struct DebuggerSession {
  struct Stop {
    std::string condition;
    bool enabled = true;
    friend bool operator==(const Stop&, const Stop&) = default;
  };
  struct Watch {
    std::string expression;
    std::optional<Change> stop;
    friend bool operator==(const Watch&, const Watch&) = default;
  };
  /// How the lanes show the run.
  struct Lanes {
    double first = 0;
    double last = 1;
    std::string lane;  ///< chosen, by its name
    bool clips = true;
    std::optional<StepSpan> range;
    bool loops = false;
    EventKind kind = EventKind::split;
    friend bool operator==(const Lanes&, const Lanes&) = default;
  };

  RecordingMark recording;  ///< for which it was made
  std::vector<Stop> breakpoints;
  std::vector<Watch> watches;
  std::map<Position, std::string> bookmarks;  ///< with their notes
  ViewSettings view;
  AnyCamera camera;
  Selection selection;
  Position position;
  Lanes lanes;
  friend bool operator==(const DebuggerSession&, const DebuggerSession&) = default;
};

/// What is there to be kept.
DebuggerSession session_of(const DebuggerModel& model, const AnyCamera& camera);
/// Makes the model go on where the session was. What the run does not have is left out; says how much of it,
/// such as "2 bookmarks"; empty if nothing is. The camera is the caller's.
std::string go_on(const DebuggerSession& session, DebuggerModel& model);

RecordingMark mark_of(const Run& run);
/// Whether the run is that of the mark, or one that goes on from it.
bool is_of(const RecordingMark& mark, const Run& run);

/// Whether the user has made anything: merely to have looked around is not worth a file.
bool has_anything(const DebuggerSession& session);
/// "3 breakpoints, 1 watch, 5 bookmarks, step 40"
std::string to_text(const DebuggerSession& session, const GivenNames& names);

/// What two people did with one recording: the breakpoints, watches and bookmarks of both, where both have
/// one with the notes of both, and all else of the first.
DebuggerSession join(DebuggerSession first, const DebuggerSession& second);
/// Whether the first has all that a user made in the second: its breakpoints, watches and bookmarks with
/// their notes, its view and its range.
bool holds(const DebuggerSession& first, const DebuggerSession& second);

}  // namespace kerf

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/config.h"
#include "core/base/given_names.h"
#include "core/objects/broad_phase.h"
#include "core/recording/object_marks.h"
#include "core/recording/their_digits.h"
#include "core/recording/theirs.h"
#include "core/trace/decision.h"
#include "core/trace/statistics.h"

namespace kerf {

/// Another configuration from a step on.
struct ConfigChange {
  std::uint32_t step = 0;  ///< the first with it
  Config config;
};

/// The subject of a recording: everything that its tree needs, and everything that its scene needs to run
/// again.
struct RecordingInfo {
  int dimension = 3;
  VolumeKind volume = VolumeKind::box;
  Config config;                      ///< of the first step, and until it changes
  std::vector<ConfigChange> changes;  ///< by step
  std::vector<Decision> decisions;    ///< what was decided instead of Algorithm 1
  std::string scene;                  ///< name in the catalogue; of an import the file that it came from
  bool imported = false;              ///< the boxes come from another engine
  GivenNames names;                   ///< what that engine calls objects and steps
  ObjectMarks marks;                  ///< labels and colours of objects
  PairDesign design;                  ///< what it does by design
  std::optional<TheirDigits> digits;  ///< how boxes and nodes of a structure were written; none: not known
  std::uint64_t seed = 1;             ///< of the scene
  std::uint32_t objects = 0;          ///< as requested; 0: the scene's own number
  std::uint32_t grow = 0;             ///< steps of growth; 0: the scene's own number
  std::uint32_t recycle = 0;          ///< steps between two objects that fall anew; 0: none does
  bool complete = false;              ///< the recording was ended in order, not killed
};

/// The configuration of a step.
const Config& config_of(const RecordingInfo& info, std::uint32_t step);

/// One row of the table of steps: the tree after a step.
struct StepRow {
  std::uint32_t step = 0;
  Statistics statistics;
  std::uint64_t changed = 0;  ///< objects that came, went or got another box
  std::uint64_t pairs = 0;
  std::uint64_t first_event = 0;
  std::uint64_t events = 0;
  std::uint64_t operators_hash = 0;  ///< of the step's rows in the table of events
  std::uint64_t state_hash = 0;
  std::uint64_t pairs_hash = 0;  ///< of the set of pairs, in any order
  std::uint64_t link = 0;        ///< of the recording's chain

  /// The time of the broad phase, in seconds.
  [[nodiscard]] double seconds() const {
    double sum = 0;
    for (const double phase : statistics.phase_seconds) sum += phase;
    return sum;
  }
};

/// A hash as people see it: 16 hexadecimal digits.
std::string to_hex(std::uint64_t hash);

/// A hash of the set of pairs; a pair reported twice changes it.
std::uint64_t hash_pairs(std::span<const Pair> pairs);

}  // namespace kerf

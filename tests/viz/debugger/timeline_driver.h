#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"
#include "viz/debugger/script.h"

namespace kerf::test {

/// Two objects at rest, so that many steps take little time.
struct LongRun {
  std::uint32_t steps = 0;
};

/// An import of so many steps: in the last two the other engine misses the first pair, and in the last one it
/// reports what is none, twice.
struct FaultyImport {
  std::uint32_t steps = 0;
};

/// What the script failed with; empty if it did not.
inline std::string played(Debugger& debugger, const std::string& script, int width = 1280, int height = 720,
                          const PictureFolder& pictures = {}) {
  try {
    ScriptPlayer(debugger, width, height, pictures).play(parse_script(script));
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "";
}

/// The debugger on a crowd of so many steps, whose recording may be changed.
class TimelineDriver {
 public:
  explicit TimelineDriver(std::uint32_t steps = 60, const std::string& sql = "") {
    Bsp<2, EventLog> tree(busy_config());
    Recorder<2> recorder(tree, file_.path(), info_of<2>(busy_config()));
    play_crowd<2>(recorder, steps, 3, [](std::uint32_t) {});
    recorder.finish();
    if (!sql.empty()) file_.change(sql);
    if (!sql.empty()) reseal(file_.path());
    debugger_.emplace(*context_, open_run(file_.path()));
  }
  explicit TimelineDriver(const LongRun& run) {
    Bsp<2, EventLog> tree(busy_config());
    Recorder<2> recorder(tree, file_.path(), info_of<2>(busy_config()));
    for (const std::uint32_t k : {0U, 1U}) {
      const auto x = 0.5F * static_cast<float>(k);
      (void)recorder.insert(ObjectId{k}, Box<2>{{x, 0}, {x + 1, 1}}, Mobility::moving);
    }
    for (std::uint32_t step = 0; step < run.steps; ++step) recorder.step();
    recorder.finish();
    debugger_.emplace(*context_, open_run(file_.path()));
  }
  /// An import whose steps have names.
  explicit TimelineDriver(const std::vector<std::string>& names) {
    Bsp<2, EventLog> tree(busy_config());
    RecordingInfo info = info_of<2>(busy_config());
    info.imported = true;
    info.names = GivenNames({}, names);
    Recorder<2> recorder(tree, file_.path(), info);
    play_crowd<2>(recorder, static_cast<std::uint32_t>(names.size()), 3, [&](std::uint32_t) {
      const std::vector<Pair> truth = oracle_pairs(tree.objects());
      recorder.add_theirs(truth, judge_theirs<2>(truth, truth, tree.objects(), TheirWorld<2>(), {}));
    });
    recorder.finish();
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  explicit TimelineDriver(const FaultyImport& run) {
    Bsp<2, EventLog> tree(busy_config());
    RecordingInfo info = info_of<2>(busy_config());
    info.imported = true;
    Recorder<2> recorder(tree, file_.path(), info);
    play_crowd<2>(recorder, run.steps, 3, [&](std::uint32_t step) {
      const std::vector<Pair> truth = oracle_pairs(tree.objects());
      std::vector<Pair> theirs = truth;
      if (step + 1 >= run.steps) theirs.erase(theirs.begin());
      Pair none{{0}, {1}};
      while (std::ranges::binary_search(truth, none)) ++none.b.value;
      if (step == run.steps) theirs.insert(theirs.end(), 2, none);
      recorder.add_theirs(theirs, judge_theirs<2>(theirs, truth, tree.objects(), TheirWorld<2>(), {}));
    });
    recorder.finish();
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  /// What the script failed with; empty if it did not.
  std::string play(const std::string& script, int width = 1280, int height = 720) {
    return played(*debugger_, script, width, height);
  }
  [[nodiscard]] Debugger& debugger() { return *debugger_; }

 private:
  TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
};

}  // namespace kerf::test

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "core/base/counted.h"
#include "core/base/poll.h"
#include "core/query/minimize.h"
#include "core/query/search.h"
#include "frames/commands/command.h"
#include "frames/commands/test_of_scenario.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/recording_picture.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_expression.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

struct MinimizeRequest {
  Expression when;
  std::filesystem::path out;
  Replace replace = Replace::nothing;

  [[nodiscard]] std::filesystem::path picture() const {
    return std::filesystem::path(out).replace_extension(".png");
  }
  [[nodiscard]] std::filesystem::path test() const {
    return std::filesystem::path(out).replace_extension(".cpp");
  }
};

template <int D>
std::optional<Position> first_hit(const std::filesystem::path& path, const Expression& when) {
  Search<D> search(std::make_shared<RecordingReader<D>>(path));
  search.take_all();
  return search.forward(when, Position::end_of(0));
}

struct SmallRun {
  std::string hit;  ///< where the condition holds
  std::uint64_t hash = 0;
};

/// Writes the recording's part and draws its picture into another.
template <int D>
SmallRun write_recording(const Scenario<D>& scenario, const MinimizeRequest& request,
                         const std::filesystem::path& recording, PartFile& picture) {
  record(scenario, recording);
  const auto hit = first_hit<D>(recording, request.when);
  const auto reader = std::make_shared<RecordingReader<D>>(recording);
  Cursor<D> cursor(reader);
  cursor.go(hit.value());
  FrameRenderer<D> renderer({1280, 720, kRecordedLayers, ""});
  picture.write(encode_png(render_moment(cursor, renderer)));
  return {to_string(hit.value(), reader->info().names), reader->rows().back().state_hash};
}

/// All three are there before one of them gets its name.
template <int D>
void write_results(const Scenario<D>& scenario, const MinimizeRequest& request) {
  PartRecording recording(request.out, request.replace);
  PartFile picture(request.picture(), request.replace);
  PartFile test(request.test(), request.replace);
  const std::string hit = recording.write([&] {
    const SmallRun run = write_recording(scenario, request, recording.path(), picture);
    test.write(test_of_scenario(scenario, request.when.text(), run.hash));
    picture.keep();
    test.keep();
    recording.keep();
    return run.hit;
  });
  std::printf("%s: %s, %s, %s, %s in them; it holds at %s\n%s: a picture of that moment\n%s: a C++ test\n",
              request.out.c_str(), counted(scenario.steps.size(), "step").c_str(),
              counted(objects_of(scenario).size(), "object").c_str(),
              counted(scenario.requests(), "request").c_str(),
              counted(acting_operators(scenario).size(), "kind of operators", "kinds of operators").c_str(),
              hit.c_str(), request.picture().c_str(), request.test().c_str());
}

template <int D>
void minimize_recording(const std::shared_ptr<RecordingReader<D>>& recording,
                        const MinimizeRequest& request) {
  const InterruptGuard interrupt;
  std::size_t trials = 0;
  std::optional<Polling> polling([&] {
    if (interrupt.requested())
      throw Interrupted("interrupted after " + counted(trials, "trial") + "; nothing was written");
  });
  Search<D> search(recording);
  const auto hit = search.forward(request.when, Position::end_of(0));
  if (!hit) throw DoesNotHold("the condition never holds in this recording, so there is nothing to minimize");
  const StepRow& row = recording->row(hit->step);
  const auto fails = [&](const Scenario<D>& scenario) {
    poll();
    ++trials;
    const PartRecording trial(request.out, Replace::earlier);
    record(scenario, trial.path());
    return first_hit<D>(trial.path(), request.when).has_value();
  };
  Replayer<D> replayer(recording);
  const Scenario<D> late = start_late<D>(replayer, hit->step, fails);
  const Scenario<D> small = minimize<D>(late, fails);
  polling.reset();
  std::printf("%s: from %s and %s\n", counted(trials, "trial").c_str(), counted(row.step, "step").c_str(),
              counted(row.statistics.objects, "object").c_str());
  write_results(small, request);
}

/// Values that differ from run to run cannot guide the search.
void check(const Expression& when) {
  const bool asks_time = std::ranges::any_of(when.parts(), [](const ExpressionPart& part) {
    const bool names =
        part.kind == ExpressionPart::Kind::variable || part.kind == ExpressionPart::Kind::median;
    return names && part.variable >= Variable::step_time && part.variable <= Variable::sweep_time;
  });
  if (asks_time) throw UsageError("--when: times differ from run to run; give a condition without them");
}

/// The test and the picture get names that the user did not give: they replace only what a test of ours shows
/// to be of an earlier `minimize`.
void check_free(const MinimizeRequest& request, bool overwrite) {
  const bool has_test = is_test_of_scenario(request.test());
  std::string in_the_way;
  int count = 0;
  for (const std::filesystem::path& file : {request.out, request.picture(), request.test()}) {
    if (!std::filesystem::exists(file) || (overwrite && (has_test || file == request.out))) continue;
    in_the_way += (count++ == 0 ? "" : ", ") + file.string();
  }
  if (count == 0) return;
  const bool is_one = count == 1;
  throw UsageError(
      in_the_way +
      (overwrite ? std::string(is_one ? " is" : " are") + " not of an earlier `kerf minimize` and " +
                       (is_one ? "is" : "are") + " not replaced; choose another name"
                 : std::string(is_one ? " exists" : " exist") + " already; choose another name, or replace " +
                       (is_one ? "it" : "them") + " with --overwrite"));
}

Replace check_files(const MinimizeRequest& request, const std::filesystem::path& recording, bool overwrite) {
  if (request.out == request.picture() || request.out == request.test())
    throw UsageError("--out '" + request.out.string() +
                     "': the picture and the test get the names with .png and .cpp; choose another ending");
  Outputs outputs({recording}, true);
  outputs.add_recording(request.out);
  outputs.add_file(request.picture());
  outputs.add_file(request.test());
  check_free(request, overwrite);
  return replace_if(overwrite);
}

class MinimizeCommand final : public Command {
 public:
  explicit MinimizeCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string when_;
  std::string out_;
  bool overwrite_ = false;
};

MinimizeCommand::MinimizeCommand(CLI::App& program)
    : Command(program, "minimize", "Find the smallest run in which a condition still holds") {
  option("FILE", file_, "A recording", "")->required();
  option("--when", when_, "The condition, see `kerf step --help`", "EXPR")->required();
  output("-o,--out", out_, "The small recording, for example small.kerf")->required();
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier recording, picture and test");
  command_->footer(
      "Objects, steps and operators are left out as long as the condition still holds (delta debugging).\n"
      "Beside the recording a picture (.png) and a self-contained C++ test (.cpp) get its name.");
}

void MinimizeCommand::run() const {
  MinimizeRequest request{parse_expression("--when", when_), out_};
  check(request.when);
  request.replace = check_files(request, file_, overwrite_);
  with_recording(file_, [&](auto recording) { minimize_recording(recording, request); });
}

}  // namespace

AnyCommand make_minimize_command(CLI::App& program) { return std::make_unique<MinimizeCommand>(program); }

}  // namespace kerf

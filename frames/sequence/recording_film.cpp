#include <algorithm>
#include <stdexcept>

#include "core/replay/recorded_looks.h"
#include "core/replay/replayer.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/film.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/their_errors.h"
#include "viz/draw/camera.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf {
namespace {

/// The common properties of all frames of a recording, found without running its tree: so a frame does not
/// depend on the frames drawn before it, and nothing jumps in the film.
template <int D>
struct Setting {
  Box<D> view;
  bool leaves_some_out = false;
  std::uint32_t largest_population = 0;
  int samples = 4;
};

/// The view holds what every frame of the whole sequence shows.
template <int D>
Setting<D> find_setting(RecordingReader<D>& recording, const StepRange& steps, Framing framing) {
  Setting<D> setting;
  SceneBox<D> view(framing);
  ViewBox<D> everything(Framing::everything);
  ObjectTable<D> table(recording.info().volume);
  std::uint32_t objects = 0;
  for (std::uint32_t step = 1; step <= steps.last; ++step) {
    for_each_request(recording.step(step).requests, table.kind(),
                     [&](const ObjectRequest<D>& request) { apply(request, table); });
    objects = std::max(objects, recording.row(step).statistics.objects);
    if (step < steps.first || (step - steps.first) % steps.stride != 0) continue;
    const std::vector<Body<D>> bodies = recorded_bodies(table);
    view.update(bodies);
    everything.update(bodies);
  }
  setting.view = view.box();
  setting.leaves_some_out = !(everything.box() == view.box());  // both have grown alike otherwise
  setting.largest_population = end_of_ramp(objects, recording.info().config);
  if (objects >= kManyBodies) setting.samples = 1;
  return setting;
}

template <int D>
class RecordingFilm final : public Film {
 public:
  explicit RecordingFilm(const RenderRequest& request)
      : recording_(std::make_shared<RecordingReader<D>>(request.recording->path)),
        replayer_(recording_, 0),
        looks_(*recording_),
        setting_(find_setting(*recording_, request.steps, parse_camera<D>(request.camera).framing)),
        planner_(request.layers, request.samples == 0 ? setting_.samples : samples_of_renderer(request)),
        stride_(request.steps.stride),
        highlight_steps_(highlight_steps(stride_)) {
    planner_.fix_view_box(setting_.view);
    if (setting_.leaves_some_out) planner_.name_outside();
    planner_.fix_largest_population(setting_.largest_population);
  }

  /// Looks at all steps whose operators a frame may still show, and at no others: so a frame does not depend
  /// on the begin of the replay.
  bool advance_to(std::uint32_t step, const GoOn& go_on) override {
    const std::uint32_t first = step > highlight_steps_ ? step - highlight_steps_ : 1;
    if (replayer_.step() + 1 < first) jump_to(first - 1);
    while (replayer_.step() < step) {
      replayer_.advance();
      take_events();
      if (replayer_.step() < step) observe();
      if (!go_on(replayer_.step())) return false;
    }
    return true;
  }

  std::vector<std::uint8_t> parcel() override {
    const std::vector<Body<D>> bodies =
        recorded_bodies<D>(replayer_.tree().objects(),
                           {looks_.at(replayer_.step()), recording_->shapes(), recording_->info().marks});
    // A replay from a keyframe finds the pairs in another order.
    std::vector<Pair> pairs(replayer_.tree().pairs().begin(), replayer_.tree().pairs().end());
    std::ranges::sort(pairs);
    const TheirErrors theirs(*recording_, replayer_.step());
    FrameInput<D> input = moment();
    input.bodies = bodies;
    input.pairs = pairs;
    input.caption = theirs.counted_in(caption());
    input.missed = theirs.missed;
    input.extra = theirs.extra;
    return pack(input, planner_.plan(input));
  }

  FrameRecord record() override {
    const std::uint32_t step = replayer_.step();
    const StepRow& row = recording_->row(step);
    FrameRecord record;
    record.step = step;
    record.given_step = given_step_name(recording_->info().names, step);
    record.objects = replayer_.tree().objects().size();
    record.pairs = row.pairs;
    record.height = row.statistics.height;
    record.leaves = row.statistics.leaves;
    record.entries = row.statistics.entries;
    record.operators = row.statistics.operators;
    for (std::uint32_t s = step > stride_ ? step - stride_ + 1 : 1; s <= step; ++s)
      record.events += recording_->row(s).events;
    record.state_hash = replayer_.tree().state_hash();
    if (record.state_hash != row.state_hash)
      throw std::runtime_error("the replay differs from the recording at step " +
                               recording_->info().names.step(step) + ": `kerf verify` says more");
    return record;
  }

  void finish(bool /*whole*/) override {}

 private:
  void jump_to(std::uint32_t step) {
    replayer_.seek(step);
    planner_.forget();
    recent_.clear();
    observe();
  }

  /// A moment that is not drawn here, but may be by another shard: both have to see the same.
  void observe() {
    const std::vector<Body<D>> bodies = recorded_bodies<D>(replayer_.tree().objects());
    FrameInput<D> input = moment();
    input.bodies = bodies;
    planner_.observe(input);
  }

  void take_events() {
    const std::uint32_t now = replayer_.step();
    keep_recent_operators(recording_->step(now).events, now, highlight_steps_, recent_);
  }

  /// What a planner needs of any step beside its bodies.
  [[nodiscard]] FrameInput<D> moment() const {
    FrameInput<D> input;
    input.tree = &replayer_.tree().tree();
    input.events = recent_;
    input.highlight_steps = highlight_steps_;
    input.caption.step = replayer_.step();
    return input;
  }

  [[nodiscard]] Caption caption() const {
    const StepRow& row = recording_->row(replayer_.step());
    return {.scene = recording_->info().scene,
            .broad_phase = broad_phase_of(recording_->info()),
            .step = replayer_.step(),
            .objects = replayer_.tree().objects().size(),
            .moving = count_moving(replayer_.tree().objects()),
            .pairs = row.pairs,
            .contacts = 0,
            .statistics = row.statistics,
            .step_name = given_step_name(recording_->info().names, row.step),
            .note = {},
            .knows_contacts = false};
  }

  std::shared_ptr<RecordingReader<D>> recording_;
  Replayer<D> replayer_;
  RecordedLooks<D> looks_;
  Setting<D> setting_;
  FramePlanner<D> planner_;
  std::uint32_t stride_;
  std::uint32_t highlight_steps_;
  std::vector<Event> recent_;  ///< operators of the last `highlight_steps_` steps
};

}  // namespace

std::unique_ptr<Film> make_recording_film(const RenderRequest& request) {
  if (request.dimension() == 2) return std::make_unique<RecordingFilm<2>>(request);
  return std::make_unique<RecordingFilm<3>>(request);
}

}  // namespace kerf

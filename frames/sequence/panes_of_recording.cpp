#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/replay/recorded_looks.h"
#include "frames/sequence/panes_film.h"
#include "frames/sequence/recording_file.h"
#include "viz/draw/camera.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

/// The boxes of a recording, which broad phases get step by step. None of them has keyframes, so that they
/// run from the first step to the last that is drawn.
template <int D>
class PanesOfRecording final : public PanesFilm<D> {
 public:
  PanesOfRecording(std::shared_ptr<RecordingReader<D>> recording, const RenderRequest& request)
      : PanesOfRecording(recording, look_through(*recording, request), request) {}

  bool advance_to(std::uint32_t step, const Film::GoOn& go_on) override {
    while (step_ < step) {
      ++step_;
      const StepRequests<D>& requests = recording_->step(step_).requests;
      apply(requests, this->broad_phases());
      this->broad_phases().step();
      take_over(*recording_, step_, table_);
      if (!go_on(step_)) return false;
    }
    return true;
  }

  std::vector<std::uint8_t> parcel() override {
    PanesFrame<D> frame;
    frame.scene = name_;
    frame.step = step_;
    frame.step_name = given_step_name(recording_->info().names, step_);
    frame.objects = table_.size();
    frame.moving = kerf::count_moving(table_);
    frame.bodies =
        recorded_bodies<D>(table_, {looks_.at(step_), recording_->shapes(), recording_->info().marks});
    frame.bounds = bounds_;
    return this->pack_with_panes(std::move(frame));
  }

  FrameRecord record() override {
    FrameRecord record;
    record.step = step_;
    record.given_step = given_step_name(recording_->info().names, step_);
    record.objects = table_.size();
    record.pairs = this->broad_phases().pairs().size();
    return record;
  }

 private:
  struct Outlook {
    Box<D> bounds;
    RivalHints<D> hints;
  };

  PanesOfRecording(std::shared_ptr<RecordingReader<D>> recording, const Outlook& outlook,
                   const RenderRequest& request)
      : PanesFilm<D>(request, all_of(outlook.hints, request)),
        name_(request.name),
        recording_(std::move(recording)),
        looks_(*recording_),
        bounds_(outlook.bounds),
        table_(recording_->info().volume) {}

  static void take_over(RecordingReader<D>& recording, std::uint32_t step, ObjectTable<D>& table) {
    for_each_request(recording.step(step).requests, table.kind(),
                     [&](const ObjectRequest<D>& request) { apply(request, table); });
  }

  /// Some trees keep fat boxes around objects.
  static Box<D> with_room(Box<D> box) {
    constexpr Scalar kRoom = 0.03F;
    const Vector<D> extent = box.extent();
    Scalar room = 0;
    for (int i = 0; i < D; ++i) room = std::max(room, kRoom * extent[i]);
    for (int i = 0; i < D; ++i) {
      box.min[i] -= room;
      box.max[i] += room;
    }
    return box;
  }

  /// The view holds what every frame shows; libraries that need bounds get those of all boxes.
  static Outlook look_through(RecordingReader<D>& recording, const RenderRequest& request) {
    SceneBox<D> view(parse_camera<D>(request.camera).framing);
    Outlook outlook;
    outlook.hints.bounds = Box<D>::empty();
    ObjectTable<D> table(recording.info().volume);
    for (std::uint32_t step = 1; step <= request.steps.last; ++step) {
      take_over(recording, step, table);
      for (std::uint32_t id = 0; id < table.bound(); ++id)
        if (table.is_placed({id})) outlook.hints.bounds = join(outlook.hints.bounds, table.box({id}));
      if (step >= request.steps.first && (step - request.steps.first) % request.steps.stride == 0)
        view.update(recorded_bodies(table));
    }
    outlook.hints.capacity = static_cast<std::uint32_t>(table.bound()) + 1;
    if (!is_valid(outlook.hints.bounds)) outlook.hints.bounds = {};
    outlook.bounds = with_room(view.box());
    return outlook;
  }

  static std::vector<std::unique_ptr<BroadPhase<D>>> all_of(const RivalHints<D>& hints,
                                                            const RenderRequest& request) {
    std::vector<std::unique_ptr<BroadPhase<D>>> all;
    all.push_back(make_broad_phase<D>(request.broad_phase, hints));
    for (const BroadPhaseChoice& choice : *request.beside) all.push_back(make_broad_phase<D>(choice, hints));
    return all;
  }

  std::string name_;
  std::shared_ptr<RecordingReader<D>> recording_;
  RecordedLooks<D> looks_;
  Box<D> bounds_;
  ObjectTable<D> table_;
  std::uint32_t step_ = 0;
};

}  // namespace

std::unique_ptr<Film> make_panes_of_recording(const RenderRequest& request) {
  return with_recording(request.recording->path,
                        [&]<int D>(std::shared_ptr<RecordingReader<D>> reader) -> std::unique_ptr<Film> {
                          return std::make_unique<PanesOfRecording<D>>(std::move(reader), request);
                        });
}

}  // namespace kerf

#include "frames/sequence/film.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <variant>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"
#include "core/trace/event_facts.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "viz/draw/camera.h"
#include "viz/draw/frame_planner.h"

namespace kerf {
namespace {

template <int D>
using WatchedTree = Bsp<D, EventLog>;

template <int D>
std::unique_ptr<BroadPhase<D>> watched_broad_phase(const SceneEntry<D>& entry, const RenderRequest& request) {
  const BroadPhaseChoice& choice = request.broad_phase;
  if (choice.is_tree()) return std::make_unique<WatchedTree<D>>(choice.config, choice.volume);
  return make_broad_phase<D>(choice, entry, request.options);
}

template <int D>
class SceneFilm final : public Film {
 public:
  SceneFilm(const SceneEntry<D>& entry, const RenderRequest& request)
      : name_(request.name),
        broad_phase_name_(request.broad_phase.name),
        planner_(request.layers, samples_of_renderer(request), parse_camera<D>(request.camera).framing),
        broad_phase_(watched_broad_phase(entry, request)),
        tree_(dynamic_cast<WatchedTree<D>*>(broad_phase_.get())),
        recording_(make_recording(request)),
        recorder_(make_recorder(tree_, request)),
        scene_(
            entry.make(recorder_ ? static_cast<BroadPhase<D>&>(*recorder_) : *broad_phase_, request.options)),
        highlight_steps_(highlight_steps(request.steps.stride)) {
    if (recorder_)
      recorder_->show([this](ObjectId object) { return appearance_of(scene_->bodies()[object.index()]); });
    const auto fixed = static_cast<std::uint32_t>(scene_->bodies().size()) - count_moving(scene_->bodies());
    const std::uint32_t moving =
        request.options.objects == 0 ? entry.default_objects : request.options.objects;
    planner_.glide();
    planner_.fix_largest_population(end_of_ramp(fixed + moving, request.broad_phase.config));
  }

  bool advance_to(std::uint32_t step, const GoOn& go_on) override {
    while (scene_->step() < step) {
      advance();
      if (!go_on(scene_->step())) return false;
    }
    return true;
  }

  std::vector<std::uint8_t> parcel() override {
    const FrameInput<D> input{.bodies = scene_->bodies(),
                              .tree = tree_ == nullptr ? nullptr : &tree_->tree(),
                              .pairs = scene_->pairs(),
                              .contacts = scene_->contacts(),
                              .events = recent_,
                              .caption = caption(),
                              .highlight_steps = highlight_steps_};
    return pack(input, planner_.plan(input));
  }

  FrameRecord record() override {
    FrameRecord record;
    record.step = scene_->step();
    record.objects = static_cast<std::uint32_t>(scene_->bodies().size());
    record.pairs = scene_->pairs().size();
    record.contacts = scene_->contacts().size();
    if (tree_ == nullptr) return record;
    const Statistics statistics = tree_->statistics();
    record.height = statistics.height;
    record.leaves = statistics.leaves;
    record.entries = statistics.entries;
    record.operators = statistics.operators;
    record.events = std::exchange(events_since_record_, 0);
    record.state_hash = tree_->state_hash();
    return record;
  }

  void finish(bool whole) override {
    if (!recorder_) return;
    close([this] { recorder_->finish(); });
    if (whole) return recording_->keep();
    std::fprintf(stderr, "kerf: what was recorded is in %s\n", recording_->keep_as_far_as_it_came().c_str());
  }

  void give_up() noexcept override {
    if (!recording_ || recording_->is_done()) return;
    try {
      const bool is_whole = end();
      const std::string steps = recording_->steps();
      if (steps.empty()) return;
      if (!is_whole) recording_->leave();
      const std::filesystem::path file = is_whole ? recording_->keep_as_far_as_it_came() : recording_->path();
      std::fprintf(stderr, "kerf: what was recorded (%s) is in %s\n", steps.c_str(), file.c_str());
    } catch (const std::exception&) {
      recording_->leave();
    }
  }

 private:
  /// Ends the recording after a failure. False if it ends with what was committed before.
  bool end() {
    const bool may_finish = recorder_ && !is_torn_;
    try {
      close([&] {
        if (may_finish) recorder_->finish();
      });
      return may_finish;
    } catch (const std::exception&) {  // the disk may be full
      return false;
    }
  }

  /// The recording can be read and named afterwards.
  template <class Finish>
  void close(Finish finish) {
    if (!recorder_) return;
    const auto closed = [this] {
      scene_.reset();  // which uses the recorder to its end
      recorder_.reset();
    };
    try {
      finish();
    } catch (...) {
      closed();
      throw;
    }
    closed();
  }

  static std::unique_ptr<PartRecording> make_recording(const RenderRequest& request) {
    if (request.record.empty()) return nullptr;
    static_cast<void>(recording_info(request));  // throws if there can be none
    return std::make_unique<PartRecording>(request.record, replace_if(request.overwrite));
  }

  [[nodiscard]] std::unique_ptr<Recorder<D>> make_recorder(WatchedTree<D>* tree,
                                                           const RenderRequest& request) const {
    if (!recording_) return nullptr;
    return std::make_unique<Recorder<D>>(*tree, recording_->path(), recording_info(request));
  }

  void advance() {
    is_torn_ = true;
    scene_->advance();
    is_torn_ = false;
    if (tree_ == nullptr) return;
    std::vector<Event> events = tree_->trace().take();
    events_since_record_ += events.size();
    keep_recent_operators(events, tree_->steps(), highlight_steps_, recent_);
  }

  [[nodiscard]] Caption caption() const {
    return {.scene = name_,
            .broad_phase = broad_phase_name_,
            .step = scene_->step(),
            .objects = static_cast<std::uint32_t>(scene_->bodies().size()),
            .moving = count_moving(scene_->bodies()),
            .pairs = scene_->pairs().size(),
            .contacts = scene_->contacts().size(),
            .statistics = tree_ == nullptr ? Statistics{} : tree_->statistics(),
            .note = {},
            .knows_contacts = true};
  }

  std::string name_;
  std::string broad_phase_name_;
  FramePlanner<D> planner_;
  std::unique_ptr<BroadPhase<D>> broad_phase_;
  WatchedTree<D>* tree_;                      ///< the same; null: it is no tree
  std::unique_ptr<PartRecording> recording_;  ///< none unless asked for
  std::unique_ptr<Recorder<D>> recorder_;     ///< the same
  std::unique_ptr<Scene<D>> scene_;           ///< after the broad phase, which it uses to its end
  std::uint32_t highlight_steps_;
  std::vector<Event> recent_;  ///< operators of the last `highlight_steps_` steps
  std::uint64_t events_since_record_ = 0;
  bool is_torn_ = false;  ///< a step was left half-made: the recorder's end would not fit its beginning
};

}  // namespace

std::uint32_t highlight_steps(std::uint32_t stride) {
  return std::clamp<std::uint32_t>(stride, 1, 10) * kHighlightSteps;
}

void keep_recent_operators(std::span<const Event> events, std::uint32_t now, std::uint32_t steps,
                           std::vector<Event>& recent) {
  std::erase_if(recent, [&](const Event& event) { return event.step + steps < now; });
  std::ranges::copy_if(events, std::back_inserter(recent), has_acted);
}

std::unique_ptr<Film> make_film(const RenderRequest& request) {
  if (request.recording)
    return request.beside ? make_panes_of_recording(request) : make_recording_film(request);
  try {
    if (request.beside) return make_panes_film(request);
    return std::visit(
        [&]<int D>(const SceneEntry<D>* entry) -> std::unique_ptr<Film> {
          return std::make_unique<SceneFilm<D>>(*entry, request);
        },
        request.scene.entry);
  } catch (const std::invalid_argument& error) {
    throw UsageError(request.name + ": " + error.what());
  }
}

}  // namespace kerf

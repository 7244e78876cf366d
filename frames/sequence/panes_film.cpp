#include <algorithm>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "frames/sequence/farm/panes_parcel.h"
#include "frames/sequence/film.h"
#include "frames/sequence/pane_of.h"
#include "frames/sequence/side_by_side.h"
#include "frames/support/errors.h"
#include "viz/draw/camera.h"
#include "viz/draw/frame_renderer.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

/// A scene whose pairs one broad phase finds, while others follow it.
template <int D>
class PanesFilm final : public Film {
 public:
  PanesFilm(const SceneEntry<D>& entry, const RenderRequest& request)
      : name_(request.name),
        names_(names_of(request)),
        is_timed_(request.timed),
        samples_(samples_of_renderer(request)),
        broad_phases_(all_of(entry, request)),
        scene_(entry.make(broad_phases_, request.options)),
        view_(parse_camera<D>(request.camera).framing) {}

  bool advance_to(std::uint32_t step, const GoOn& go_on) override {
    while (scene_->step() < step) {
      scene_->advance();
      if (!go_on(scene_->step())) return false;
    }
    return true;
  }

  std::vector<std::uint8_t> parcel() override {
    const auto bodies = scene_->bodies();
    view_.update(bodies);
    PanesFrame<D> frame{name_,
                        scene_->step(),
                        count_moving(bodies),
                        {bodies.begin(), bodies.end()},
                        {scene_->contacts().begin(), scene_->contacts().end()},
                        view_.box(),
                        has_strips_,
                        is_timed_,
                        choose_samples(bodies.size()),
                        {}};
    for (std::size_t k = 0; k < names_.size(); ++k) {
      frame.panes.push_back(
          pane_of<D>(names_[k], broad_phases_[k], bodies, frame.bounds,
                     is_timed_ ? std::optional(broad_phases_.milliseconds(k)) : std::nullopt));
      has_strips_ |= !frame.panes.back().parts.lists.empty();
    }
    frame.has_strips = has_strips_;
    return pack_panes(frame);
  }

  FrameRecord record() override {
    FrameRecord record;
    record.step = scene_->step();
    record.objects = static_cast<std::uint32_t>(scene_->bodies().size());
    record.pairs = scene_->pairs().size();
    record.contacts = scene_->contacts().size();
    return record;
  }

  void finish(bool /*whole*/) override {}

 private:
  static std::vector<std::string> names_of(const RenderRequest& request) {
    std::vector<std::string> names{request.broad_phase.name};
    for (const BroadPhaseChoice& choice : *request.beside) names.push_back(choice.name);
    return names;
  }

  static SideBySide<D> all_of(const SceneEntry<D>& entry, const RenderRequest& request) {
    std::vector<std::unique_ptr<BroadPhase<D>>> all;
    all.push_back(make_broad_phase<D>(request.broad_phase, entry, request.options));
    for (const BroadPhaseChoice& choice : *request.beside)
      all.push_back(make_broad_phase<D>(choice, entry, request.options));
    return SideBySide<D>(std::move(all));
  }

  /// As FramePlanner: once edges are jagged, they stay so.
  int choose_samples(std::size_t bodies) {
    if (samples_ == 0 && bodies >= kManyBodies) samples_ = 1;
    return samples_ == 0 ? 4 : samples_;
  }

  std::string name_;
  std::vector<std::string> names_;
  bool is_timed_;
  int samples_;  ///< 0: as bodies allow
  bool has_strips_ = false;
  SideBySide<D> broad_phases_;
  std::unique_ptr<Scene<D>> scene_;  ///< after the broad phases, which it uses to its end
  ViewBox<D> view_;
};

}  // namespace

std::unique_ptr<Film> make_panes_film(const RenderRequest& request) {
  return std::visit(
      [&](const auto* entry) -> std::unique_ptr<Film> {
        if constexpr (std::is_same_v<decltype(entry), const SceneEntry<2>*>) {
          return std::make_unique<PanesFilm<2>>(*entry, request);
        } else {
          return std::make_unique<PanesFilm<3>>(*entry, request);
        }
      },
      request.scene.entry);
}

}  // namespace kerf

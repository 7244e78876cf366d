#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "frames/sequence/panes_film.h"
#include "viz/draw/camera.h"
#include "viz/draw/gliding_box.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

/// A scene whose pairs one broad phase finds, while others follow it.
template <int D>
class PanesOfScene final : public PanesFilm<D> {
 public:
  PanesOfScene(const SceneEntry<D>& entry, const RenderRequest& request)
      : PanesFilm<D>(request, all_of(entry, request)),
        name_(request.name),
        scene_(entry.make(this->broad_phases(), request.options)),
        view_(parse_camera<D>(request.camera).framing) {}

  bool advance_to(std::uint32_t step, const Film::GoOn& go_on) override {
    while (scene_->step() < step) {
      scene_->advance();
      if (!go_on(scene_->step())) return false;
    }
    return true;
  }

  std::vector<std::uint8_t> parcel() override {
    const auto bodies = scene_->bodies();
    view_.update(bodies);
    glide_.go_on(view_.box(), view_.needed());
    PanesFrame<D> frame;
    frame.scene = name_;
    frame.step = scene_->step();
    frame.objects = static_cast<std::uint32_t>(bodies.size());
    frame.moving = count_moving(bodies);
    frame.bodies.assign(bodies.begin(), bodies.end());
    frame.contacts.assign(scene_->contacts().begin(), scene_->contacts().end());
    frame.bounds = *glide_.box();
    return this->pack_with_panes(std::move(frame));
  }

  FrameRecord record() override {
    FrameRecord record;
    record.step = scene_->step();
    record.objects = static_cast<std::uint32_t>(scene_->bodies().size());
    record.pairs = scene_->pairs().size();
    record.contacts = scene_->contacts().size();
    return record;
  }

 private:
  static std::vector<std::unique_ptr<BroadPhase<D>>> all_of(const SceneEntry<D>& entry,
                                                            const RenderRequest& request) {
    std::vector<std::unique_ptr<BroadPhase<D>>> all;
    all.push_back(make_broad_phase<D>(request.broad_phase, entry, request.options));
    for (const BroadPhaseChoice& choice : *request.beside)
      all.push_back(make_broad_phase<D>(choice, entry, request.options));
    return all;
  }

  std::string name_;
  std::unique_ptr<Scene<D>> scene_;
  ViewBox<D> view_;
  GlidingBox<D> glide_;  ///< towards it
};

}  // namespace

std::unique_ptr<Film> make_panes_film(const RenderRequest& request) {
  return std::visit(
      [&]<int D>(const SceneEntry<D>* entry) -> std::unique_ptr<Film> {
        return std::make_unique<PanesOfScene<D>>(*entry, request);
      },
      request.scene.entry);
}

}  // namespace kerf

#include "frames/story/story_maker.h"

#include <stdexcept>

#include "frames/sequence/farm/frame_parcel.h"
#include "frames/story/slide_plane.h"
#include "frames/support/errors.h"
#include "frames/support/raw_bytes.h"
#include "viz/draw/camera.h"
#include "viz/draw/frame_renderer.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

/// Takes a RawWriter and what it writes, or a RawReader and what it reads.
void insert_fields(auto& bytes, auto& of) {
  bytes(of.title, of.figures, of.sentence, of.acting, of.moment, of.progress, of.turn, of.step, of.levels);
  for (auto& end : of.ends) bytes(end);
  bytes.each(of.curves, [&](auto& curve) { bytes(curve.name, curve.color, curve.values); });
}

FrameOptions story_options(const RenderRequest& request) {
  FrameOptions options;
  options.width = request.size.width;
  options.height = request.size.height;
  options.layers = request.layers;
  options.camera = request.camera;
  options.camera_path = request.camera_path;
  options.backend = request.backend;
  options.letters = story_letters(options.width, options.height);
  options.margins = story_margins(options.width, options.height);
  return options;
}

template <int D>
class StoryMaker final : public FrameMaker {
 public:
  explicit StoryMaker(const RenderRequest& request)
      : camera_(parse_camera<D>(request.camera)), renderer_(story_options(request)) {}

  Made make(const std::string& /*file*/, std::span<const std::uint8_t> parcel,
            std::optional<std::uint64_t> /*kept*/) override {
    RawReader in(parcel);
    StoryInsert insert;
    insert_fields(in, insert);
    FrameParcel<D> frame = unpack<D>(in.get<std::vector<std::uint8_t>>());
    if (insert.moment) slide_plane(frame.plan, *insert.moment, insert.progress);
    if constexpr (D == 3) {
      CameraChoice<3> turned = camera_;
      turned.yaw += insert.turn;
      renderer_.set_camera(turned);
    }
    StoryPanels panels;
    panels.title = insert.title;
    panels.figures = insert.figures;
    panels.sentence = insert.sentence;
    panels.tree = &frame.plan.snapshot;
    panels.largest_population = frame.plan.largest_population;
    panels.levels = insert.levels;
    panels.acting = insert.acting;
    panels.curves = &insert.curves;
    panels.step = insert.step;
    panels.ends = insert.ends;
    renderer_.set_sketch([&](const View& view, const Font& font, Overlay& overlay) {
      draw_story(view, font, panels, overlay);
    });
    const Image& image = renderer_.render(frame.input(), frame.plan);
    return {pixel_hash(image), &image};
  }

 private:
  CameraChoice<D> camera_;
  FrameRenderer<D> renderer_;
};

}  // namespace

std::vector<std::uint8_t> pack_story(const StoryInsert& insert, const std::vector<std::uint8_t>& frame) {
  RawWriter out;
  insert_fields(out, insert);
  out(frame);
  return out.take();
}

std::unique_ptr<FrameMaker> make_story_maker(const StoryRequest& request) {
  try {
    if (request.pictures.dimension() == 2) return std::make_unique<StoryMaker<2>>(request.pictures);
    return std::make_unique<StoryMaker<3>>(request.pictures);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace kerf

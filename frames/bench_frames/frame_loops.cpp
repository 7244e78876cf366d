#include "frames/bench_frames/frame_loops.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "frames/sequence/farm/forked_crew.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/farm/picture_maker.h"
#include "viz/draw/frame_renderer.h"
#include "viz/gl/context.h"
#include "viz/image/png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace kerf {
namespace {

/// Boxes that drift about in a cube, half as many pairs as boxes among them, and their tree.
class Crowd {
 public:
  explicit Crowd(std::uint32_t boxes);

  void advance();
  /// Valid until the next step.
  [[nodiscard]] FrameInput<3> input() const;

 private:
  [[nodiscard]] Box<3> box_of(std::size_t k) const;

  float side_;  ///< of the cube; the boxes' sides are about one
  std::vector<Body<3>> bodies_;
  std::vector<Vector<3>> velocities_;
  Bsp<3, EventLog> tree_;
  std::vector<Event> events_;
};

/// n boxes of side s in a cube of side a overlap in about n^2/2 (2s/a)^3 pairs; that is n/2 for a = 2 s
/// n^(1/3).
float side_for(std::uint32_t boxes) { return 2 * std::cbrt(static_cast<float>(boxes)); }

Crowd::Crowd(std::uint32_t boxes) : side_(side_for(boxes)) {
  Random random(7);
  for (std::uint32_t i = 0; i < boxes; ++i) {
    Body<3> body;
    Brick<3> brick;
    for (int axis = 0; axis < 3; ++axis) {
      body.pose.position[axis] = static_cast<float>(random.uniform(0, side_));
      brick.half[axis] = static_cast<float>(random.uniform(0.3, 0.7));
    }
    body.shape = brick;
    Vector<3> velocity;
    for (int axis = 0; axis < 3; ++axis) velocity[axis] = static_cast<float>(random.uniform(-0.05, 0.05));
    velocities_.push_back(velocity);
    bodies_.push_back(body);
    bodies_.back().box = box_of(i);
    (void)tree_.insert({i}, bodies_.back().box, Mobility::moving);
  }
  tree_.step();
}

Box<3> Crowd::box_of(std::size_t k) const {
  const Vector<3>& half = std::get<Brick<3>>(bodies_[k].shape).half;
  return {bodies_[k].pose.position - half, bodies_[k].pose.position + half};
}

void Crowd::advance() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Vector<3>& position = bodies_[k].pose.position;
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] += velocities_[k][axis];
      if (position[axis] < 0 || position[axis] > side_) velocities_[k][axis] = -velocities_[k][axis];
    }
    bodies_[k].box = box_of(k);
    (void)tree_.move({static_cast<std::uint32_t>(k)}, bodies_[k].box);
  }
  tree_.step();
  events_ = tree_.trace().take();
}

FrameInput<3> Crowd::input() const {
  FrameInput<3> input;
  input.bodies = bodies_;
  input.tree = &tree_.tree();
  input.pairs = tree_.pairs();
  input.events = events_;
  input.caption.scene = "crowd";
  input.caption.broad_phase = "kerf-paper";
  input.caption.step = tree_.steps();
  input.caption.objects = static_cast<std::uint32_t>(bodies_.size());
  input.caption.moving = input.caption.objects;
  input.caption.pairs = tree_.pairs().size();
  input.caption.statistics = tree_.statistics();
  return input;
}

FrameOptions options_of_loop(const FrameLoop& loop) {
  FrameOptions options;
  options.width = loop.size.width;
  options.height = loop.size.height;
  options.samples = 1;
  return options;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void run_naive_loop(const FrameLoop& loop) {
  Crowd crowd(loop.boxes);
  FrameRenderer<3> renderer(options_of_loop(loop));
  for (std::uint32_t frame = 0; frame < loop.frames; ++frame) {
    crowd.advance();
    const Image& image = renderer.render(crowd.input());
    const std::string path = loop.folder / frame_file_name("naive", frame);
    if (stbi_write_png(path.c_str(), image.width, image.height, 4, image.rgba.data(),
                       static_cast<int>(image.stride())) == 0)
      throw std::runtime_error("cannot write " + path);
  }
}

void run_pipeline(const FrameLoop& loop) {
  RenderRequest request;
  request.scene = find_scene("buckets");  // any 3D scene: it does not run
  request.size = loop.size;
  request.out = loop.folder;
  ForkedCrew crew(
      loop.workers, 0, [&] { return make_picture_maker(request); },
      [](const FrameRecord& /*record*/, const Image& /*image*/) {});
  Crowd crowd(loop.boxes);
  FramePlanner<3> planner(request.layers, 1);
  for (std::uint32_t frame = 0; frame < loop.frames; ++frame) {
    crowd.advance();
    const FrameInput<3> input = crowd.input();
    FrameOrder order;
    order.parcel = pack(input, planner.plan(input));
    order.record.objects = loop.boxes;
    order.record.file = frame_file_name("pipeline", frame);
    crew.add(std::move(order));
  }
  crew.finish();
}

double measure_encoding(const FrameLoop& loop) {
  constexpr int kTimes = 5;
  tune_allocator_for_rendering();  // as in the workers of `kerf render`, or half of the time would go into
                                   // new pages
  Crowd crowd(loop.boxes);
  crowd.advance();
  FrameRenderer<3> renderer(options_of_loop(loop));
  const Image image = renderer.render(crowd.input());
  double best = 1e9;
  for (int i = 0; i < kTimes; ++i) {
    const double start = processor_seconds();
    write_png(loop.folder / "encoding.png", image, Replace::earlier, Sync::later);
    best = std::min(best, processor_seconds() - start);
  }
  return best;
}

}  // namespace kerf

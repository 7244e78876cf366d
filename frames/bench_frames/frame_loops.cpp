#include "frames/bench_frames/frame_loops.h"

#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <string>

#include "frames/bench_frames/crowd.h"
#include "frames/sequence/farm/forked_crew.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/farm/picture_maker.h"
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

FrameOptions options_of(const FrameLoop& loop) {
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
  FrameRenderer<3> renderer(options_of(loop));
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
  FrameRenderer<3> renderer(options_of(loop));
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

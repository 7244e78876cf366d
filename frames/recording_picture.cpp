#include "frames/recording_picture.h"

#include <algorithm>

#include "frames/recording_file.h"
#include "viz/draw/frame_renderer.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

/// Operators of the last steps, as far as they had happened at that moment.
template <int D>
std::vector<Event> recent_operators(const Cursor<D>& cursor) {
  const Position& now = cursor.position();
  std::vector<Event> recent;
  for (std::uint32_t step = now.step > kHighlightSteps ? now.step - kHighlightSteps : 1; step <= now.step;
       ++step)
    std::ranges::copy_if(cursor.recording().step(step).events, std::back_inserter(recent),
                         [&](const Event& event) {
                           return event.id <= now.event && std::holds_alternative<OperatorActed>(event.body);
                         });
  return recent;
}

template <int D>
Caption caption_of(const Cursor<D>& cursor) {
  const auto& recording = cursor.recording();
  const ObjectTable<D>& objects = cursor.state().latest;
  Caption caption;
  caption.scene = recording.info().scene;
  caption.broad_phase = broad_phase_of(recording.info());
  caption.step = cursor.position().step;
  caption.objects = objects.size();
  caption.moving = count_moving(objects);
  caption.pairs = cursor.state().pairs.size();
  if (caption.step > 0) caption.statistics = recording.row(caption.step).statistics;
  if (const auto event = cursor.event()) caption.note = describe(*event);
  return caption;
}

}  // namespace

template <int D>
void draw_moment(Cursor<D>& cursor, const PictureSize& size, const std::filesystem::path& path) {
  const std::vector<Body<D>> bodies = recorded_bodies(cursor.state().latest);
  const std::vector<Event> events = recent_operators(cursor);
  FrameRenderer<D> renderer({size.width, size.height, LayerSet::all(), ""});
  const FrameInput<D> input{.bodies = bodies,
                            .tree = &cursor.state().tree,
                            .pairs = cursor.state().pairs,
                            .contacts = {},
                            .events = events,
                            .caption = caption_of(cursor)};
  write_png(path, renderer.render(input));
}

template void draw_moment<2>(Cursor<2>&, const PictureSize&, const std::filesystem::path&);
template void draw_moment<3>(Cursor<3>&, const PictureSize&, const std::filesystem::path&);

}  // namespace kerf

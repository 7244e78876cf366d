#include "frames/sequence/recording_picture.h"

#include <algorithm>

#include "core/replay/recorded_looks.h"
#include "core/trace/event_facts.h"
#include "core/tree/statistics_of.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/their_errors.h"
#include "viz/draw/frame_planner.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

/// Operators of the last steps that happened before this moment.
template <int D>
std::vector<Event> recent_operators(RecordingReader<D>& recording, const Position& now) {
  std::vector<Event> recent;
  for (std::uint32_t step = now.step > kHighlightSteps ? now.step - kHighlightSteps : 1; step <= now.step;
       ++step)
    std::ranges::copy_if(recording.step(step).events, std::back_inserter(recent),
                         [&](const Event& event) { return event.id <= now.event && has_acted(event); });
  return recent;
}

/// Nodes that an operator has removed are marked at their old place: in the trees of the steps before, and in
/// the one right before this moment.
template <int D>
void observe_moments_before(Cursor<D>& cursor, FramePlanner<D>& planner) {
  const Position now = cursor.position();
  const auto observe = [&](const Tree<D>& tree, const ObjectTable<D>& latest, const Position& at) {
    const std::vector<Event> events = recent_operators(cursor.recording(), at);
    const std::vector<Body<D>> bodies = recorded_bodies<D>(latest);
    FrameInput<D> input;
    input.bodies = bodies;
    input.tree = &tree;
    input.events = events;
    input.caption.step = at.step;
    planner.observe(input);
  };
  Replayer<D>& replayer = cursor.replayer();
  for (std::uint32_t step = now.step - std::min(now.step, kHighlightSteps); step < now.step; ++step) {
    replayer.seek(step);
    observe(replayer.tree().tree(), replayer.tree().objects(), Position::end_of(step));
  }
  if (now.is_end() || now.event == 0) return;
  const auto before = state_before(replayer, now.event);
  observe(before.tree, before.latest, {now.step, now.event - 1});
}

/// The text for an event. In the middle of a step the pairs are those of the step before.
std::string note_of(const Event& event, const GivenNames& names) {
  return describe(event, names) +
         (event.step > 1 ? " (pairs: of step " + names.step(event.step - 1) + ")" : "");
}

/// The ramp of colours is that of the whole recording, as in its film: so moments can be compared.
template <int D>
std::uint32_t end_of_ramp_of(const RecordingReader<D>& recording) {
  std::uint32_t objects = 0;
  for (const StepRow& row : recording.rows()) objects = std::max(objects, row.statistics.objects);
  return end_of_ramp(objects, recording.info().config);
}

template <int D>
Caption caption_of(const Cursor<D>& cursor) {
  const auto& recording = cursor.recording();
  const ObjectTable<D>& objects = cursor.state().latest;
  Caption caption;
  caption.scene = recording.info().scene;
  caption.broad_phase = broad_phase_of(recording.info());
  caption.step = cursor.position().step;
  caption.step_name = given_step_name(recording.info().names, caption.step);
  caption.objects = objects.size();
  caption.moving = count_moving(objects);
  caption.pairs = cursor.state().pairs.size();
  if (const auto event = cursor.event()) {
    caption.note = note_of(*event, recording.info().names);
    caption.statistics = statistics_of(cursor.state().tree, cursor.state().scheduler);
  } else if (caption.step > 0) {
    caption.statistics = recording.row(caption.step).statistics;
  }
  caption.knows_contacts = false;
  return caption;
}

}  // namespace

template <int D>
const Image& render_moment(Cursor<D>& cursor, FrameRenderer<D>& renderer) {
  RecordedLooks<D> looks(cursor.recording());
  const std::vector<Body<D>> bodies = recorded_bodies<D>(
      cursor.state().latest,
      {looks.at(cursor.position().step), cursor.recording().shapes(), cursor.recording().info().marks});
  const std::vector<Event> events = recent_operators(cursor.recording(), cursor.position());
  const Position now = cursor.position();
  const TheirErrors theirs(cursor.recording(), now.is_end() ? now.step : now.step - 1);
  const FrameInput<D> input{.bodies = bodies,
                            .tree = &cursor.state().tree,
                            .pairs = cursor.state().pairs,
                            .contacts = {},
                            .events = events,
                            .caption = theirs.counted_in(caption_of(cursor)),
                            .missed = theirs.missed,
                            .extra = theirs.extra};
  ViewBox<D> view;
  view.update(bodies);
  FramePlanner<D> planner(kRecordedLayers, 0);
  planner.fix_view_box(view.box());
  planner.fix_largest_population(end_of_ramp_of(cursor.recording()));
  observe_moments_before(cursor, planner);
  return renderer.render(input, planner.plan(input));
}

template <int D>
void draw_moment(Cursor<D>& cursor, const PictureSize& size, const std::filesystem::path& path,
                 Replace replace) {
  FrameRenderer<D> renderer({size.width, size.height, kRecordedLayers, ""});
  write_png(path, render_moment(cursor, renderer), replace);
}

template const Image& render_moment<2>(Cursor<2>&, FrameRenderer<2>&);
template const Image& render_moment<3>(Cursor<3>&, FrameRenderer<3>&);
template void draw_moment<2>(Cursor<2>&, const PictureSize&, const std::filesystem::path&, Replace);
template void draw_moment<3>(Cursor<3>&, const PictureSize&, const std::filesystem::path&, Replace);

}  // namespace kerf

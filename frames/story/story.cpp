#include "frames/story/story.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "frames/sequence/farm/forked_crew.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/farm/solo_crew.h"
#include "frames/sequence/film.h"
#include "frames/sequence/record_scene.h"
#include "frames/story/blend.h"
#include "frames/story/story_course.h"
#include "frames/story/story_maker.h"
#include "frames/story/story_still.h"
#include "frames/story/story_timeline.h"
#include "frames/story/story_words.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"
#include "frames/support/scratch_folder.h"
#include "viz/draw/highlights.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr double kTurn = 120;  ///< degrees that the camera turns in the whole film

std::string figures_of(const Caption& caption, const GivenNames& names) {
  return "step " + names.step(caption.step) + ", " + with_commas(caption.objects) +
         (caption.objects == 1 ? " object, " : " objects, ") + with_commas(caption.pairs) +
         (caption.pairs == 1 ? " pair" : " pairs");
}

/// The frames of a film between its steps.
template <int D>
class Between {
 public:
  explicit Between(Film& film) : film_(film) {}

  /// Steps may not fall. False if `go_on` stopped it.
  bool go_to(double step, std::uint32_t last, const Film::GoOn& go_on) {
    const auto whole = static_cast<std::uint32_t>(step);
    if (at_ < whole) {
      const bool is_known = next_ && at_ + 1 == whole;
      if (!is_known && !film_.advance_to(whole, go_on)) return false;
      now_ = is_known ? std::move(*next_) : unpack<D>(film_.parcel());
      next_.reset();
      at_ = whole;
    }
    part_ = step - whole;
    if (part_ == 0 || next_ || whole == last) return true;
    if (!film_.advance_to(whole + 1, go_on)) return false;
    next_ = unpack<D>(film_.parcel());
    return true;
  }
  [[nodiscard]] std::vector<std::uint8_t> parcel() const {
    FrameInput<D> input = now_.input();
    const std::vector<Body<D>> bodies =
        next_ ? blend(now_.bodies, next_->bodies, part_) : std::vector<Body<D>>();
    if (next_) input.bodies = bodies;
    return pack(input, now_.plan);
  }
  [[nodiscard]] const FrameParcel<D>& now() const { return now_; }

 private:
  Film& film_;
  FrameParcel<D> now_;
  std::optional<FrameParcel<D>> next_;  ///< of the step behind, once it is asked for
  std::uint32_t at_ = 0;
  double part_ = 0;
};

class Story {
 public:
  Story(const StoryRequest& request, const InterruptGuard& interrupt)
      : request_(request), interrupt_(interrupt), crew_(make_crew()) {}

  void run() {
    StoryCourse course = look();
    if (request_.pictures.dimension() == 2)
      draw<2>(course);
    else
      draw<3>(course);
  }

 private:
  std::unique_ptr<FrameCrew> make_crew() {
    const auto start = [this] { return make_story_maker(request_); };
    auto deliver = [this](const FrameRecord& record, const Image& image) { take(record.index, image); };
    const int workers = request_.pictures.workers;
    if (workers == 0) return std::make_unique<SoloCrew>(start, std::move(deliver));
    const auto bytes = std::size_t{4} * static_cast<std::size_t>(request_.pictures.size.width) *
                       static_cast<std::size_t>(request_.pictures.size.height);
    return std::make_unique<ForkedCrew>(workers, bytes, start, std::move(deliver));
  }

  /// The crew's thread.
  void take(std::uint32_t index, const Image& image) {
    files_->add(index, image);
    if (index != still_index_ || request_.still.empty()) return;
    still_.emplace(request_.still, request_.pictures.film.replace);
    still_->write(encode_png(image));
  }

  StoryCourse look() {
    const ScratchFolder scratch;
    const RenderRequest& pictures = request_.pictures;
    std::filesystem::path file = pictures.recording ? pictures.recording->path : scratch.path() / "run.kerf";
    if (!pictures.recording) {
      RenderRequest recorded = pictures;
      recorded.record = file;
      try {
        record_scene(recorded, CostOfRecording::silent);
      } catch (const Interrupted&) {
        throw Interrupted("interrupted; no film was made");
      }
    }
    const ProgressLine progress;
    StoryCourse course = follow_course(file, pictures.steps, request_.beside, [&](std::uint32_t step) {
      progress.show("counting tests, step " + std::to_string(step) + "/" +
                    std::to_string(pictures.steps.last));
      return !interrupt_.requested();
    });
    if (interrupt_.requested()) throw Interrupted("interrupted; no film was made");
    return course;
  }

  template <int D>
  void draw(const StoryCourse& course) {
    const StepRange& steps = request_.pictures.steps;
    const auto moments = choose_moments(course.operators, steps, request_.moments);
    std::vector<std::uint32_t> stops;
    for (const StoryMoment& moment : moments) stops.push_back(moment.step);
    const auto frames = story_frames(steps.first, steps.last, stops, request_.frames, request_.hold);
    still_index_ = frame_of_still(frames, moments, course.operators, request_.hold);
    files_.emplace(request_.pictures.film, request_.pictures.size, request_.frames);
    try {
      draw_frames<D>(frames, moments, course);
    } catch (...) {
      crew_.reset();  // pictures in flight still go into the film
      files_.reset();
      throw;
    }
    files_->finish();
    if (still_) still_->keep();
  }

  template <int D>
  void draw_frames(const std::vector<StoryFrame>& frames, const std::vector<StoryMoment>& moments,
                   const StoryCourse& course) {
    const std::unique_ptr<Film> film = make_film(request_.pictures);
    Between<D> between(*film);
    const StepRange& steps = request_.pictures.steps;
    const ProgressLine progress;
    const Stint stint;
    const Film::GoOn go_on = [&](std::uint32_t /*step*/) { return !interrupt_.requested(); };
    for (std::size_t k = 0; k < frames.size(); ++k) {
      progress.show("frame " + std::to_string(k + 1) + "/" + std::to_string(frames.size()) + "  " +
                    stint.left(static_cast<double>(k), static_cast<double>(frames.size())));
      if (interrupt_.requested() || !between.go_to(frames[k].step, steps.last, go_on))
        throw Interrupted("interrupted; no film was made");
      add<D>(k, frames, between, course, moments);
    }
    crew_->finish();
  }

  template <int D>
  void add(std::size_t k, const std::vector<StoryFrame>& frames, const Between<D>& between,
           const StoryCourse& course, const std::vector<StoryMoment>& moments) {
    const FrameParcel<D>& now = between.now();
    StoryInsert insert;
    insert.title = now.caption.scene;
    insert.figures = figures_of(now.caption, course.names);
    if (frames[k].moment) insert.moment = moments[*frames[k].moment];
    tell_operator(now.plan, now.caption.step, course.names, insert);
    insert.progress = frames[k].progress;
    insert.turn = kTurn * (static_cast<double>(k) / static_cast<double>(frames.size()) - 0.5);
    insert.step = now.caption.step;
    insert.ends = {course.names.step(1), course.names.step(request_.pictures.steps.last)};
    insert.levels = course.levels;
    insert.curves = course.curves;
    FrameOrder order;
    order.record.index = static_cast<std::uint32_t>(k);
    order.parcel = pack_story(insert, between.parcel());
    order.wants_image = true;
    crew_->add(std::move(order));
  }

  const StoryRequest& request_;
  const InterruptGuard& interrupt_;
  std::unique_ptr<FrameCrew> crew_;  ///< before all that may have threads
  std::optional<FilmFiles> files_;   ///< from the first picture on
  std::uint32_t still_index_ = 0;
  std::optional<PartFile> still_;
};

}  // namespace

void make_story(const StoryRequest& request) {
  const InterruptGuard interrupt;  // before there is a file that an interrupt would leave
  Outputs outputs({request.pictures.recording ? request.pictures.recording->path : std::filesystem::path(),
                   request.pictures.camera_file},
                  request.pictures.overwrite);
  add_outputs(request.pictures.film, outputs);
  outputs.add_file(request.still);
  make_writable_folder(std::filesystem::absolute(request.pictures.film.video).parent_path());
  if (!request.still.empty())
    make_writable_folder(std::filesystem::absolute(request.still).parent_path(), "--still");
  Story(request, interrupt).run();
}

}  // namespace kerf

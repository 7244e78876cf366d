#include "frames/python/recording.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/poll.h"
#include "core/query/explain_event.h"
#include "core/query/explain_node.h"
#include "core/query/explain_pair.h"
#include "core/query/minimize.h"
#include "core/query/search.h"
#include "core/replay/cursor.h"
#include "core/replay/what_if.h"
#include "frames/python/arrays.h"
#include "frames/python/config_from.h"
#include "frames/python/errors.h"
#include "frames/python/interrupts.h"
#include "frames/python/recorded_rows.h"
#include "frames/python/use_once.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/recording_picture.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

template <int D>
py::array given_array(const GivenBox<D>& box) {
  py::array_t<double> array({py::ssize_t{2}, py::ssize_t{D}});
  std::ranges::copy(box.max, std::ranges::copy(box.min, array.mutable_data()).out);
  return array;
}

template <int D>
PairWhy python_why(const PairExplanation<D>& found, const RecordingInfo& info) {
  PairWhy why;
  why.step = found.step;
  why.a = found.pair.a.value;
  why.b = found.pair.b.value;
  why.is_pair = found.is_pair;
  why.reported = found.reported;
  why.undecided = found.undecided_axis.has_value();
  why.boxes_overlap = found.boxes_overlap;
  why.both_fixed = found.both_fixed;
  why.axis = found.axis;
  why.margin = found.margin;
  why.a_box = given_array(found.a_box);
  why.b_box = given_array(found.b_box);
  if (found.shared_leaf) why.leaf = found.shared_leaf->value;
  if (found.shared_since) why.since = found.shared_since->id;
  std::ranges::transform(found.history, std::back_inserter(why.changes), &PairChange::step);
  why.text = to_text(found, info);
  return why;
}

/// Throws ValueError for a whole number that float64 does not hold.
double float64_of(const ConditionNumber& number, std::uint32_t step) {
  const std::optional<long double> whole = number.whole();
  if (whole && static_cast<long double>(number.nearest) != *whole)
    throw py::value_error("expression: at the end of step " + std::to_string(step) +
                          " of the recording it is " + to_text(number) +
                          ", which is not exact in float64; subtract a number near it in the expression");
  return number.nearest;
}

/// `kerf.Recording` of one dimension.
template <int D>
class RecordingOf final : public PythonRecording {
 public:
  RecordingOf(const std::filesystem::path& path, bool is_part)
      : path_(path),
        is_part_(is_part),
        reader_(of_recording([&] { return std::make_shared<RecordingReader<D>>(path); })) {}

  [[nodiscard]] int dimension() const override { return D; }
  [[nodiscard]] std::filesystem::path path() const override { return path_; }
  [[nodiscard]] std::uint32_t steps() const override { return reader_->steps(); }
  [[nodiscard]] const RecordingInfo& info() const override { return reader_->info(); }
  [[nodiscard]] py::array rows() const override { return step_array(reader_->rows()); }

  [[nodiscard]] py::array events(std::uint32_t first, std::uint32_t last) override {
    Interrupts interrupts;
    const auto found = undisturbed([&] {
      check_step(last);
      std::vector<PythonEvent> events;
      for (std::uint32_t step = std::max(first, 1U); step <= last && !interrupts.requested(); ++step)
        std::ranges::transform(reader_->step(step).events, std::back_inserter(events),
                               [](const Event& event) { return python::to_python(event); });
      return events;
    });
    interrupts.rethrow();
    return py::array_t<PythonEvent>(static_cast<py::ssize_t>(found.size()), found.data());
  }

  [[nodiscard]] py::array pairs(std::uint32_t step) override {
    return pair_array(undisturbed([&] {
      (void)objects_at(step);
      const auto pairs = replayer_->tree().pairs();
      return std::vector<Pair>(pairs.begin(), pairs.end());
    }));
  }

  [[nodiscard]] py::array their_pairs(std::uint32_t step) override {
    return pair_array(undisturbed([&] {
      check_step(step);
      if (!reader_->their_step(step))
        throw RecordingError(
            "the recording has no pairs of another engine: only what `kerf import --pairs` makes has");
      return reader_->their_pairs(step);
    }));
  }

  [[nodiscard]] py::array ids(std::uint32_t step) override {
    return id_array(undisturbed([&] { return ids_at(step); }));
  }

  [[nodiscard]] py::array boxes(std::uint32_t step) override {
    return box_array<D>(undisturbed([&] {
      const std::vector<ObjectId> ids = ids_at(step);
      std::vector<Box<D>> boxes;
      std::ranges::transform(ids, std::back_inserter(boxes),
                             [&](ObjectId id) { return replayer_->tree().objects().box(id); });
      return boxes;
    }));
  }

  [[nodiscard]] py::array fixed(std::uint32_t step) override {
    const auto fixed = undisturbed([&] {
      std::vector<std::uint8_t> all;
      for (const ObjectId id : ids_at(step)) all.push_back(objects_at(step).is_fixed(id) ? 1 : 0);
      return all;
    });
    py::array_t<bool> flags(static_cast<py::ssize_t>(fixed.size()));
    std::ranges::transform(fixed, flags.mutable_data(), [](std::uint8_t flag) { return flag != 0; });
    return flags;
  }

  [[nodiscard]] std::string describe(std::uint64_t event) override {
    return undisturbed([&] { return kerf::describe(reader_->event(event), info().names); });
  }

  [[nodiscard]] std::optional<Position> find(const std::string& condition, const Position& from,
                                             bool backward) override {
    const Expression expression = Expression::parse(condition);
    Interrupts interrupts;
    const auto found = undisturbed([&] {
      const auto progress = [&](std::uint32_t) { return !interrupts.requested(); };
      return backward ? search().backward(expression, from, progress)
                      : search().forward(expression, from, progress);
    });
    interrupts.rethrow();
    return found;
  }

  [[nodiscard]] py::array values(const std::string& text) override {
    const Expression expression = Expression::parse_value(text);
    if (expression.asks_events())
      throw py::value_error("expression: '" + text +
                            "' is about single events, and values are those of steps");
    Interrupts interrupts;
    const auto values = undisturbed([&] {
      std::vector<double> found;
      for (std::uint32_t step = 1; step <= steps() && !interrupts.requested(); ++step)
        found.push_back(float64_of(search().value(expression, Position::end_of(step)), step));
      return found;
    });
    interrupts.rethrow();
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  }

  [[nodiscard]] PairWhy why(std::uint32_t a, std::uint32_t b, std::uint32_t step) override {
    if (a == b) throw py::value_error("b: an object makes no pair with itself");
    return python_why(undisturbed([&] {
                        const ObjectTable<D>& objects = objects_at(step);
                        for (const std::uint32_t id : {a, b})
                          if (id >= objects.bound())
                            throw RecordingError("the recording has no object " + info().names.object({id}) +
                                                 " up to step " + std::to_string(step));
                        return explain_pair(*replayer_, step, make_pair(ObjectId{a}, ObjectId{b}));
                      }),
                      info());
  }

  [[nodiscard]] std::string why_event(std::uint64_t event) override {
    return undisturbed([&] {
      if (!replayer_) replayer_.emplace(reader_);
      return to_text(explain_event(*replayer_, event), info().names);
    });
  }

  [[nodiscard]] std::string why_node(std::uint32_t node, std::uint32_t step) override {
    return undisturbed([&] {
      (void)objects_at(step);
      return to_text(explain_node(*replayer_, step, NodeId{node}), info().names);
    });
  }

  void what_if(const WhatIf& change, const std::filesystem::path& out, bool overwrite) override {
    RecordingInfo changed = info();
    const Config config = config_from(config_of(info(), change.first), change.config);
    Interrupts interrupts;
    undisturbed([&] {
      check_recording(out, overwrite, path_);
      if (!replayer_) replayer_.emplace(reader_);
      if (change.refuse) decide(changed, *replayer_, *change.refuse);
      if (change.take) decide(changed, *replayer_, change.take->first, change.take->second);
      if (config != config_of(info(), change.first)) change_config(changed, *reader_, change.first, config);
      PartRecording part(out, replace_if(overwrite));
      part.write([&] {
        if (rerun(*reader_, changed, part.path(), [&] { return interrupts.requested(); })) part.keep();
      });
    });
    interrupts.rethrow();
  }

  void minimize(const StillHolds& holds, std::uint32_t last, const std::filesystem::path& out,
                bool overwrite) override {
    Interrupts interrupts;
    undisturbed([&] {
      const Polling polling([&] {
        if (interrupts.requested()) interrupts.rethrow();
      });
      if (!replayer_) replayer_.emplace(reader_);
      const auto fails = [&](const Scenario<D>& scenario) {
        poll();
        const PartRecording trial(out, Replace::earlier);
        record(scenario, trial.path());
        const Polling quiet([] {});  // what interrupts `holds` is for it to see
        return holds(trial.path());
      };
      const Scenario<D> late = start_late<D>(*replayer_, last, fails);
      const Scenario<D> small = kerf::minimize<D>(late, fails);
      PartRecording part(out, replace_if(overwrite));
      part.write([&] {
        record(small, part.path());
        part.keep();
      });
    });
  }

  [[nodiscard]] RecordingComparison compare(PythonRecording& other) override {
    auto* const same = dynamic_cast<RecordingOf<D>*>(&other);
    if (same == nullptr)
      throw py::value_error("other: one recording is in 2D and one in 3D, so there is nothing to compare");
    if (same == this) {  // two readers, since each keeps what it read last
      RecordingOf<D> again(path_, is_part_);
      return compare(again);
    }
    const UseOnce use(same->in_use_);
    return undisturbed([&] { return kerf::compare(*reader_, *same->reader_); });
  }

  [[nodiscard]] py::array picture(const Position& at, const PictureOptions& options) override {
    const FrameOptions frame = frame_options(options);
    std::optional<FrameRenderer<D>> renderer;  // the picture is its own
    const Image* const image = undisturbed([&] {
      check_step(at.step);
      Cursor<D> cursor(reader_);
      cursor.go(at);
      renderer.emplace(frame);
      return &render_moment(cursor, *renderer);
    });
    return rgb_array(*image);
  }

  [[nodiscard]] Position position_of(std::uint64_t event) const override {
    const auto step = reader_->step_of(event);
    if (!step) throw RecordingError("the recording ends before event " + std::to_string(event));
    return {*step, event};
  }

 private:
  [[nodiscard]] const ObjectTable<D>& objects_at(std::uint32_t step) {
    check_step(step);
    if (!replayer_) replayer_.emplace(reader_);
    if (replayer_->step() != step) replayer_->seek(step);
    return replayer_->tree().objects();
  }

  [[nodiscard]] std::vector<ObjectId> ids_at(std::uint32_t step) {
    const ObjectTable<D>& objects = objects_at(step);
    std::vector<ObjectId> ids;
    for_each_placed(objects, [&](ObjectId object) { ids.push_back(object); });
    return ids;
  }

  void check_step(std::uint32_t step) const {
    if (step > steps())
      throw RecordingError("the recording ends with step " + std::to_string(steps()) + ", before step " +
                           std::to_string(step));
  }

  [[nodiscard]] Search<D>& search() {
    if (!search_) search_.emplace(reader_);
    if (is_part_) search_->take_all();
    return *search_;
  }

  /// Calls `work` while nothing else uses the recording and Python's other threads run.
  template <class Work>
  auto undisturbed(Work work) {
    const UseOnce use(in_use_);
    const py::gil_scoped_release others_run;
    return of_recording(work);
  }

  std::filesystem::path path_;
  bool is_part_;
  std::shared_ptr<RecordingReader<D>> reader_;
  std::optional<Replayer<D>> replayer_;  ///< none: not needed so far
  std::optional<Search<D>> search_;
  bool in_use_ = false;
};

std::unique_ptr<PythonRecording> open(const std::filesystem::path& path, bool is_part) {
  const int dimension = of_recording([&] { return read_recording_info(path).dimension; });
  if (dimension == 2) return std::make_unique<RecordingOf<2>>(path, is_part);
  return std::make_unique<RecordingOf<3>>(path, is_part);
}

}  // namespace

std::unique_ptr<PythonRecording> open_recording(const std::filesystem::path& path) {
  return open(path, false);
}

std::unique_ptr<PythonRecording> open_part(const std::filesystem::path& path) { return open(path, true); }

Verdict verify_recording(const std::filesystem::path& path, std::uint32_t oracle_every) {
  Interrupts interrupts;
  Verdict verdict = [&] {
    const py::gil_scoped_release others_run;
    return of_recording(
        [&] { return verify(path, oracle_every, [&](std::uint32_t) { return !interrupts.requested(); }); });
  }();
  interrupts.rethrow();
  if (const std::string why = why_unjudged(verdict, oracle_every); !why.empty())
    throw py::value_error("oracle_every: " + why);
  return verdict;
}

}  // namespace kerf::python

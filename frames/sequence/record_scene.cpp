#include "frames/sequence/record_scene.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <type_traits>

#include "core/base/counted.h"
#include "core/recording/recorder.h"
#include "core/recording/recording_reader.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"

namespace kerf {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int D>
void print_summary(const std::filesystem::path& file, double recording, double run) {
  const RecordingReader<D> reader(file);
  const RecordingSize size = reader.size();
  const double each =
      size.changed == 0 ? 0 : static_cast<double>(size.blocks) / static_cast<double>(size.changed);
  const std::uint32_t objects = reader.steps() == 0 ? 0 : reader.rows().back().statistics.objects;
  std::printf("%s: %s, %s, %.1f MB (%.1f of them keyframes)\n", file.c_str(),
              counted(reader.steps(), "step").c_str(), counted(objects, "object").c_str(),
              static_cast<double>(std::filesystem::file_size(file)) * 1e-6,
              static_cast<double>(size.keyframes) * 1e-6);
  std::printf("%.1f bytes for each of %s that changed; recording took %.1f %% of %.1f s\n", each,
              counted(size.changed, "box", "boxes").c_str(), 100 * recording / run, run);
}

/// How far a scene came, and what recording it took.
struct Take {
  std::uint32_t steps = 0;
  RecordingWish wish = RecordingWish::more;
  double recording = 0;  ///< seconds
};

/// Runs the scene and records it into the part, which is closed then.
template <int D>
Take record_steps(const SceneEntry<D>& entry, const RenderRequest& request, const std::filesystem::path& part,
                  const RecordingWatch& watch) {
  const InterruptGuard interrupt;
  Take take;
  Bsp<D, EventLog> tree(request.broad_phase.config, request.broad_phase.volume);
  Recorder<D> recorder(tree, part, recording_info(request));
  const auto scene = entry.make(recorder, request.options);
  recorder.show([&](ObjectId object) { return appearance_of(scene->bodies()[object.index()]); });
  {
    Progress progress({1, request.steps.last, 1});
    while (scene->step() < request.steps.last && take.wish == RecordingWish::more) {
      scene->advance();
      (void)tree.trace().take();
      progress.update(scene->step(), scene->step());
      if (watch) take.wish = watch(scene->step());
      if (interrupt.requested()) take.wish = RecordingWish::none;
    }
  }
  recorder.finish();
  take.steps = scene->step();
  take.recording = recorder.seconds();
  return take;
}

template <int D>
std::filesystem::path record(const SceneEntry<D>& entry, const RenderRequest& request, CostOfRecording cost,
                             const RecordingWatch& watch) {
  const auto start = std::chrono::steady_clock::now();
  (void)recording_info(request);  // throws if there can be none
  PartRecording part(request.record, replace_if(request.overwrite));
  return part.write([&]() -> std::filesystem::path {
    const Take take = record_steps(entry, request, part.path(), watch);
    const double run = seconds_since(start);
    const bool whole = take.steps == request.steps.last;
    if (whole) part.keep();
    std::filesystem::path file = whole ? request.record : part.keep_as_far_as_it_came();
    if (cost == CostOfRecording::printed) print_summary<D>(file, take.recording, run);
    if (!whole && take.wish == RecordingWish::none)
      throw Interrupted("interrupted: " + counted_of(take.steps, request.steps.last, "step") + " in " +
                        file.string());
    return file;
  });
}

}  // namespace

std::filesystem::path record_scene(const RenderRequest& request, CostOfRecording cost,
                                   const RecordingWatch& watch) {
  Outputs({}, request.overwrite).add_recording(request.record);
  try {
    return std::visit([&](const auto* entry) { return record(*entry, request, cost, watch); },
                      request.scene.entry);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace kerf

#include "frames/sequence/record_scene.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <type_traits>

#include "core/base/counted.h"
#include "core/recording/recording_reader.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/record_run.h"
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

/// How far a scene came, and why it ended.
struct Take {
  RunSoFar run;
  RecordingWish wish = RecordingWish::more;
};

/// Runs the scene and records it into the part, which is closed then.
template <int D>
Take record_steps(const SceneEntry<D>& entry, const RenderRequest& request, const std::filesystem::path& part,
                  const RecordingWatch& watch) {
  const InterruptGuard interrupt;
  Take take;
  Progress progress({1, request.steps.last, 1});
  const auto go_on = [&](std::uint32_t step) {
    progress.update(step, step);
    if (watch) take.wish = watch(step);
    if (interrupt.requested()) take.wish = RecordingWish::none;
    return take.wish == RecordingWish::more;
  };
  take.run =
      record_run<D>({entry, request.options, recording_info(request), request.steps.last}, part, go_on);
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
    const bool whole = take.run.steps == request.steps.last;
    if (whole) part.keep();
    std::filesystem::path file = whole ? request.record : part.keep_as_far_as_it_came();
    if (cost == CostOfRecording::printed) print_summary<D>(file, take.run.recording, run);
    if (!whole && take.wish == RecordingWish::none)
      throw Interrupted("interrupted: " + counted_of(take.run.steps, request.steps.last, "step") + " in " +
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
    throw UsageError(request.name + ": " + error.what());
  }
}

}  // namespace kerf

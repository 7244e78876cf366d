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

template <int D>
std::filesystem::path record(const SceneEntry<D>& entry, const RenderRequest& request, CostOfRecording cost,
                             const RecordingWatch& watch) {
  const InterruptGuard interrupt;
  const auto start = std::chrono::steady_clock::now();
  const RecordingInfo info = recording_info(request);
  PartRecording part(request.record, replace_if(request.overwrite));
  Bsp<D, EventLog> tree(request.broad_phase.config, request.broad_phase.volume);
  Recorder<D> recorder(tree, part.path(), info);
  const auto scene = entry.make(recorder, request.options);
  recorder.show([&](ObjectId object) { return appearance_of(scene->bodies()[object.index()]); });
  auto wish = RecordingWish::more;
  {
    Progress progress({1, request.steps.last, 1});
    while (scene->step() < request.steps.last && wish == RecordingWish::more) {
      scene->advance();
      (void)tree.trace().take();
      progress.update(scene->step(), scene->step());
      if (watch) wish = watch(scene->step());
      if (interrupt.requested()) wish = RecordingWish::none;
    }
  }
  recorder.finish();
  const double run = seconds_since(start);
  const bool whole = scene->step() == request.steps.last;
  if (whole) part.keep();
  std::filesystem::path file = whole ? request.record : part.keep_as_far_as_it_came();
  if (cost == CostOfRecording::printed) print_summary<D>(file, recorder.seconds(), run);
  if (!whole && wish == RecordingWish::none)
    throw Interrupted("interrupted: " + counted_of(scene->step(), request.steps.last, "step") + " in " +
                      file.string());
  return file;
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

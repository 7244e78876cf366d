#include "frames/sequence/record_run.h"

#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"

namespace kerf {

RecordingInfo info_of_run(const std::string& scene, int dimension, const SceneOptions& options,
                          const Config& config, VolumeKind volume) {
  RecordingInfo info;
  info.dimension = dimension;
  info.volume = volume;
  info.config = config;
  info.scene = scene;
  info.seed = options.seed;
  info.objects = options.objects;
  info.grow = options.steps;
  info.recycle = options.recycle;
  return info;
}

template <int D>
RunSoFar record_run(const RunToRecord<D>& run, const std::filesystem::path& file,
                    const std::function<bool(std::uint32_t)>& go_on) {
  Bsp<D, EventLog> tree(run.info.config, run.info.volume);
  Recorder<D> recorder(tree, file, run.info);
  const auto scene = run.entry.make(recorder, run.options);
  recorder.show([&](ObjectId object) { return appearance_of(scene->bodies()[object.index()]); });
  bool goes_on = true;
  while (scene->step() < run.steps && goes_on) {
    scene->advance();
    (void)tree.trace().take();
    goes_on = go_on(scene->step());
  }
  recorder.finish();
  return {scene->step(), recorder.seconds()};
}

template RunSoFar record_run<2>(const RunToRecord<2>&, const std::filesystem::path&,
                                const std::function<bool(std::uint32_t)>&);
template RunSoFar record_run<3>(const RunToRecord<3>&, const std::filesystem::path&,
                                const std::function<bool(std::uint32_t)>&);

}  // namespace kerf

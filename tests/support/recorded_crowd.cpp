#include "tests/support/recorded_crowd.h"

#include <sqlite3.h>

#include <stdexcept>

#include "tests/support/config_of.h"

namespace kerf::test {

void change_recording(const std::filesystem::path& recording, const std::string& sql) {
  sqlite3* database = nullptr;
  if (sqlite3_open(recording.c_str(), &database) != SQLITE_OK ||
      sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    throw std::runtime_error(sqlite3_errmsg(database));
  sqlite3_close(database);
}

Config busy_config() {
  return config_of(
      "directions=24,min_threshold=6,max_threshold=10,schedule_interval=2,max_redundancy=0.2,repair_"
      "redundancy=0.3,swap_share=1");
}

template <int D>
RecordingInfo info_of(const Config& config, VolumeKind volume) {
  RecordingInfo info;
  info.dimension = D;
  info.config = config;
  info.volume = volume;
  info.scene = "crowd";
  return info;
}

template <int D>
void record_crowd(const std::filesystem::path& path, std::uint32_t steps, const Config& config,
                  VolumeKind volume) {
  Bsp<D, EventLog> tree(config, volume);
  Recorder<D> recorder(tree, path, info_of<D>(config, volume));
  play_crowd<D>(recorder, steps, 1, [&](std::uint32_t step) {
    if (step % 2 == 0) (void)tree.trace().take();  // when events are taken does not matter
  });
  recorder.finish();
}

template <int D>
void record_another_run(const std::filesystem::path& path, std::uint32_t steps) {
  constexpr std::uint32_t kBeforeAllStandStill = 8;
  Bsp<D, EventLog> tree(busy_config());
  Recorder<D> recorder(tree, path, info_of<D>(tree.config()));
  play_crowd<D>(recorder, steps, 1, [&](std::uint32_t step) {
    if (step != kBeforeAllStandStill) return;
    for_each_placed(tree.objects(), [&](ObjectId object) {
      Box<D> box = tree.objects().box(object);
      box.min[0] += 6;
      box.max[0] += 6;
      (void)tree.move(object, box);
    });
  });
  recorder.finish();
}

template RecordingInfo info_of<2>(const Config&, VolumeKind);
template RecordingInfo info_of<3>(const Config&, VolumeKind);
template void record_crowd<2>(const std::filesystem::path&, std::uint32_t, const Config&, VolumeKind);
template void record_crowd<3>(const std::filesystem::path&, std::uint32_t, const Config&, VolumeKind);
template void record_another_run<2>(const std::filesystem::path&, std::uint32_t);
template void record_another_run<3>(const std::filesystem::path&, std::uint32_t);

}  // namespace kerf::test

#pragma once

#include <filesystem>
#include <string>

#include "core/base/config.h"
#include "core/recording/recorder.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

/// Changes the file behind Kerf's back.
void change_recording(const std::filesystem::path& recording, const std::string& sql);

/// A name for a new file; whatever lies there goes away with the object.
class TemporaryRecording {
 public:
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "crowd.kerf"; }
  void change(const std::string& sql) const { change_recording(path(), sql); }

 private:
  TemporaryFolder folder_;
};

/// Small leaves and much to do, so that every operator acts soon.
Config busy_config();

template <int D>
RecordingInfo info_of(const Config& config, VolumeKind volume = VolumeKind::box);

/// Moves a crowd of boxes through `steps` steps of every kind of motion that MovingBoxes knows: objects come,
/// go, fly, gather, grow, stand still, have broken boxes. `after_step` is called after each.
template <int D, class AfterStep>
void play_crowd(BroadPhase<D>& broad_phase, std::uint32_t steps, std::uint64_t seed, AfterStep after_step) {
  MovingBoxes<D> crowd(broad_phase, 12, 0.6, seed);
  crowd.add(120, 6);
  for (std::uint32_t step = 1; step <= steps; ++step) {
    switch (step % 12) {
      case 1:
        crowd.add(6);
        break;
      case 3:
        crowd.gather(0.3);
        break;
      case 4:
        crowd.damage(3);
        break;
      case 5:
        crowd.heal();
        break;
      case 6:
        crowd.replace(5);
        break;
      case 7:
        crowd.gather(-0.3);
        break;
      case 8:
        crowd.remove(5);
        break;
      case 9:
        break;  // all stand still
      case 10:
        crowd.scale(step % 24 == 10 ? 1.2 : 0.8);
        break;
      default:
        crowd.bounce(0.05);
        break;
    }
    broad_phase.step();
    after_step(step);
  }
}

/// Records `play_crowd`.
template <int D>
void record_crowd(const std::filesystem::path& path, std::uint32_t steps, const Config& config,
                  VolumeKind volume = VolumeKind::box);
/// The same, but from step 9 on it is another run than the recording says: all objects were moved behind
/// the recorder's back.
template <int D>
void record_another_run(const std::filesystem::path& path, std::uint32_t steps);

}  // namespace kerf::test

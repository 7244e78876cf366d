#pragma once

#include <string_view>
#include <vector>

#include "viz/draw/camera.h"

namespace kerf {

/// A camera that moves: key frames by step, with smooth ways between them.
///
/// The text has one key frame a line: a step and camera settings as in `parse_camera`, "120 yaw=90,pitch=20".
/// Empty lines and comments behind # are skipped. Each number follows its own curve through the key frames
/// that give it, without overshooting them (monotone cubics, Fritsch and Carlson 1980); distances and widths
/// by their logarithms. The camera stands still before the first and after the last one.
template <int D>
class CameraPath {
 public:
  /// Throws std::invalid_argument that names the line.
  explicit CameraPath(std::string_view text);

  /// `fixed`, overridden by the path at that step.
  [[nodiscard]] CameraChoice<D> at(double step, const CameraChoice<D>& fixed) const;

 private:
  struct Key {
    double step = 0;
    double value = 0;
    double slope = 0;
  };
  /// One number of the camera.
  using Track = std::vector<Key>;

  static double value_at(const Track& track, double step);
  void add_line(std::string_view line, int number);
  static void smooth(Track& track);

  std::vector<Track> tracks_;  ///< by number
  double last_step_ = -1;
};

}  // namespace kerf

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "core/geometry/box.h"
#include "viz/draw/box_of_interest.h"

namespace kerf {

/// The user's settings of the camera; `frame_all` chooses the missing ones, for what `framing` names.
template <int D>
struct CameraChoice;

/// Orbit camera, y up. Angles in degrees: yaw 0 looks along -z, 90 along -x, pitch 90 straight down; fov is
/// the vertical one.
template <>
struct CameraChoice<3> {
  double yaw = 30;
  double pitch = 38;
  double fov = 35;
  std::optional<double> distance;  ///< from the target, in scene units
  std::optional<Eigen::Vector3d> target;
  Framing framing = Framing::most;
  /// Whether it looks elsewhere than at what is framed.
  [[nodiscard]] bool is_aimed() const { return distance || target; }
  friend bool operator==(const CameraChoice&, const CameraChoice&) = default;
};

/// Pan and zoom, y up.
template <>
struct CameraChoice<2> {
  std::optional<Eigen::Vector2d> center;
  std::optional<double> width;  ///< scene units across the picture
  Framing framing = Framing::most;
  [[nodiscard]] bool is_aimed() const { return center || width; }
  friend bool operator==(const CameraChoice&, const CameraChoice&) = default;
};

/// Reads "yaw=30,pitch=38,fov=35,distance=40,target=0:0:0" (3D) or "center=0:5,width=40" (2D), any part of
/// it, with or without "all" for Framing::everything and, in 3D, a direction "top", "front", "side" or "iso"
/// (all axes alike), or nothing; what comes later replaces what came before. Throws std::invalid_argument
/// that says what is wrong and what can be given.
template <int D>
CameraChoice<D> parse_camera(std::string_view text);

/// The words that stand for yaw and pitch in 3D.
inline constexpr std::array<std::string_view, 4> kDirectionNames{"iso", "top", "front", "side"};
bool is_direction(std::string_view word);

/// A rectangle of the picture in pixels, y down.
struct Viewport {
  double left = 0;
  double top = 0;
  double width = 1;
  double height = 1;
};

/// Takes scene points to the picture. 2D points have z = 0.
struct View {
  Eigen::Matrix4d clip_from_world;                     ///< y down: row 0 of the picture is its top
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();       ///< 3D only
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  ///< unit, from the eye into the scene
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();    ///< unit, level
  double pixels_per_unit_at_one = 1;                   ///< pixels of a unit length at depth 1 (2D: anywhere)
  bool perspective = false;                            ///< 3D
  double near = 0;                                     ///< 3D: parts nearer to the eye are not drawn
  double nearest = 0;                                  ///< 3D: depth at which the framed box begins ...
  double farthest = 1;                                 ///< ... and ends
  double picture_width = 1;
  double picture_height = 1;

  /// Pixels that a length of one takes at `point`.
  [[nodiscard]] double pixels_per_unit(const Eigen::Vector3d& point) const;
  /// How deep a point lies in the framed box: 0 at its near end, 1 at its far end and beyond; 0 in 2D.
  [[nodiscard]] double depth_share(const Eigen::Vector3d& point) const;
  /// Pixel position; nothing if the point lies behind the eye.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;
};

/// The view in which all of `box` lies within `viewport`, with a small margin, unless `choice` says
/// otherwise.
template <int D>
View frame_all(const Box<D>& box, const CameraChoice<D>& choice, const Viewport& viewport, int picture_width,
               int picture_height);

}  // namespace kerf

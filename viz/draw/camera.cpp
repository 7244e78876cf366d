#include "viz/draw/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

struct CameraPreset {
  double yaw;
  double pitch;
};

/// In the order of their names.
const CameraPreset* preset_called(std::string_view name) {
  static constexpr std::array<CameraPreset, kDirectionNames.size()> kPresets{
      {{45, 35.264}, {0, 90}, {0, 0}, {90, 0}}};
  const auto found = std::ranges::find(kDirectionNames, name);
  return found == kDirectionNames.end()
             ? nullptr
             : &kPresets[static_cast<std::size_t>(found - kDirectionNames.begin())];
}

constexpr double kMargin = 0.96;  // the part of the viewport that the framed box uses

[[noreturn]] void fail(const std::string& what, std::string_view valid) {
  throw std::invalid_argument("camera: " + what + "; give any of " + std::string(valid));
}

/// Reads numbers separated by colons; exactly N of them.
template <int N>
Eigen::Matrix<double, N, 1> parse_numbers(std::string_view key, std::string_view text,
                                          std::string_view valid) {
  Eigen::Matrix<double, N, 1> result;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < N; ++i) {
    const auto [next, error] = std::from_chars(at, end, result[i]);
    const bool right_end = i + 1 < N ? next != end && *next == ':' : next == end;
    if (error != std::errc{} || !right_end || !std::isfinite(result[i]))
      fail("\"" + std::string(text) + "\" is no value of " + std::string(key), valid);
    if (i + 1 < N) at = next + 1;
  }
  return result;
}

double parse_between(std::string_view key, std::string_view text, double low, double high,
                     std::string_view valid) {
  const double value = parse_numbers<1>(key, text, valid)[0];
  if (value < low || value > high)
    fail("\"" + std::string(text) + "\" is out of range for " + std::string(key), valid);
  return value;
}

constexpr double kLargest = 1e12;

template <int N>
Eigen::Matrix<double, N, 1> parse_point(std::string_view key, std::string_view text, std::string_view valid) {
  auto point = parse_numbers<N>(key, text, valid);
  if (point.cwiseAbs().maxCoeff() > kLargest)
    fail("\"" + std::string(text) + "\" is out of range for " + std::string(key), valid);
  return point;
}

/// Calls `set(key, value)` for each KEY=VALUE and for the word "all", whose value is empty; it returns false
/// for an unknown key.
template <class Set>
void parse_assignments(std::string_view text, std::string_view valid, Set set) {
  std::set<std::string_view> given;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item == "all" || is_direction(item) ? item.size() : item.find('=');
    if (equals == std::string_view::npos) fail("\"" + std::string(item) + "\" is not KEY=VALUE", valid);
    if (!set(item.substr(0, equals), item.substr(std::min(equals + 1, item.size()))))
      fail("unknown key \"" + std::string(item.substr(0, equals)) + "\"", valid);
    if (!given.insert(item.substr(0, equals)).second)
      fail("\"" + std::string(item.substr(0, equals)) + "\" stands twice", valid);
    if (comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
    if (text.empty()) fail("nothing follows the last comma", valid);
  }
}

/// Pixels of the picture from the coordinates -1 to 1 (x right, y up) within the viewport.
Eigen::Matrix4d into_viewport(const Viewport& viewport, int picture_width, int picture_height) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m(0, 0) = viewport.width / picture_width;
  m(0, 3) = (2 * viewport.left + viewport.width) / picture_width - 1;
  m(1, 1) = -viewport.height / picture_height;
  m(1, 3) = (2 * viewport.top + viewport.height) / picture_height - 1;
  return m;
}

std::array<Eigen::Vector3d, 8> corners(const Box<3>& box) {
  std::array<Eigen::Vector3d, 8> result;
  for (unsigned i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      result[i][axis] = (i >> axis & 1U) != 0 ? double{box.max[axis]} : double{box.min[axis]};
  }
  return result;
}

/// Right, up and forward of an orbit camera.
struct Basis {
  Eigen::Matrix3d rows;
  [[nodiscard]] Eigen::Vector3d into(const Eigen::Vector3d& p) const { return rows * p; }
};

Basis orbit_basis(double yaw_degrees, double pitch_degrees) {
  const double yaw = yaw_degrees * std::numbers::pi / 180;
  const double pitch = pitch_degrees * std::numbers::pi / 180;
  const Eigen::Vector3d forward(-std::sin(yaw) * std::cos(pitch), -std::sin(pitch),
                                -std::cos(yaw) * std::cos(pitch));
  const Eigen::Vector3d right(std::cos(yaw), 0, -std::sin(yaw));
  Basis basis;
  basis.rows << right.transpose(), right.cross(forward).transpose(), forward.transpose();
  return basis;
}

/// The eye, in the camera's basis, from which every point just fits between the planes of slope `tan_x`,
/// `tan_y`.
Eigen::Vector3d tightest_eye(const Basis& basis, const std::array<Eigen::Vector3d, 8>& points,
                             const Eigen::Vector2d& slope) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d most = Eigen::Vector2d::Constant(-kInfinity);
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kInfinity);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = basis.into(point);
    most = most.cwiseMax(p.head<2>() - slope * p.z());
    least = least.cwiseMin(p.head<2>() + slope * p.z());
  }
  const Eigen::Vector2d depth = (least - most).cwiseQuotient(2 * slope);
  Eigen::Vector3d eye;
  eye << 0.5 * (most + least), depth.minCoeff();
  return eye;
}

Eigen::Vector3d place_eye(const Box<3>& box, const CameraChoice<3>& choice, const Basis& basis,
                          const Eigen::Vector2d& slope) {
  const auto points = corners(box);
  if (!choice.target && !choice.distance)
    return basis.rows.transpose() * tightest_eye(basis, points, kMargin * slope);
  const Eigen::Vector3d target = choice.target.value_or(0.5 * (points.front() + points.back()));
  double distance = 0;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = basis.into(point - target);
    distance = std::max(distance, p.head<2>().cwiseAbs().cwiseQuotient(kMargin * slope).maxCoeff() - p.z());
  }
  return target - basis.rows.transpose().col(2) * choice.distance.value_or(distance);
}

}  // namespace

bool is_direction(std::string_view word) { return preset_called(word) != nullptr; }

template <>
CameraChoice<3> parse_camera<3>(std::string_view text) {
  constexpr std::string_view kValid =
      "all,top|front|side|iso,yaw=DEGREES,pitch=-89..90,fov=5..120,distance=UNITS,target=X:Y:Z";
  CameraChoice<3> choice;
  std::string turned_by;
  parse_assignments(text, kValid, [&](std::string_view key, std::string_view value) {
    const CameraPreset* const preset = preset_called(key);
    if (preset != nullptr && !turned_by.empty())
      fail("\"" + std::string(key) + "\" after \"" + turned_by + "\" would undo it", kValid);
    if (preset != nullptr || key == "yaw" || key == "pitch") turned_by = key;
    if (key == "all" && value.empty()) {
      choice.framing = Framing::everything;
    } else if (preset != nullptr && value.empty()) {
      choice.yaw = preset->yaw;
      choice.pitch = preset->pitch;
    } else if (key == "yaw") {
      choice.yaw = parse_between(key, value, -3600, 3600, kValid);
    } else if (key == "pitch") {
      choice.pitch = parse_between(key, value, -89, 90, kValid);
    } else if (key == "fov") {
      choice.fov = parse_between(key, value, 5, 120, kValid);
    } else if (key == "distance") {
      choice.distance = parse_between(key, value, 1e-6, kLargest, kValid);
    } else if (key == "target") {
      choice.target = parse_point<3>(key, value, kValid);
    } else {
      return false;
    }
    return true;
  });
  return choice;
}

template <>
CameraChoice<2> parse_camera<2>(std::string_view text) {
  constexpr std::string_view kValid = "all,center=X:Y,width=UNITS";
  CameraChoice<2> choice;
  parse_assignments(text, kValid, [&](std::string_view key, std::string_view value) {
    if (key == "all" && value.empty()) {
      choice.framing = Framing::everything;
    } else if (key == "center") {
      choice.center = parse_point<2>(key, value, kValid);
    } else if (key == "width") {
      choice.width = parse_between(key, value, 1e-6, kLargest, kValid);
    } else {
      return false;
    }
    return true;
  });
  return choice;
}

double View::pixels_per_unit(const Eigen::Vector3d& point) const {
  if (!perspective) return pixels_per_unit_at_one;
  return pixels_per_unit_at_one / std::max(1e-9, forward.dot(point - eye));
}

double View::depth_share(const Eigen::Vector3d& point) const {
  if (!perspective) return 0;
  return std::clamp((forward.dot(point - eye) - nearest) / std::max(1e-9, farthest - nearest), 0.0, 1.0);
}

std::optional<Eigen::Vector2d> View::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector4d clip = clip_from_world * point.homogeneous();
  if (clip.w() <= near) return std::nullopt;
  return Eigen::Vector2d(0.5 * (clip.x() / clip.w() + 1) * picture_width,
                         0.5 * (clip.y() / clip.w() + 1) * picture_height);
}

template <>
View frame_all<3>(const Box<3>& box, const CameraChoice<3>& choice, const Viewport& viewport,
                  int picture_width, int picture_height) {
  const Basis basis = orbit_basis(choice.yaw, choice.pitch);
  const double tan_y = std::tan(0.5 * choice.fov * std::numbers::pi / 180);
  const Eigen::Vector2d slope(tan_y * viewport.width / viewport.height, tan_y);
  View view;
  view.eye = place_eye(box, choice, basis, slope);
  view.forward = basis.rows.row(2);
  view.right = basis.rows.row(0);
  double nearest = std::numeric_limits<double>::max();
  double farthest = 0;
  for (const Eigen::Vector3d& corner : corners(box)) {
    const double depth = view.forward.dot(corner - view.eye);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  view.nearest = nearest;
  view.farthest = farthest;
  farthest = std::max(2 * farthest, 1e-6);
  view.near = std::max(0.25 * nearest, 2e-3 * farthest);
  Eigen::Matrix4d camera = Eigen::Matrix4d::Identity();
  camera.topLeftCorner<3, 3>() = basis.rows;
  camera.topRightCorner<3, 1>() = -basis.rows * view.eye;
  Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
  lens(0, 0) = 1 / slope.x();
  lens(1, 1) = 1 / slope.y();
  lens(2, 2) = (farthest + view.near) / (farthest - view.near);
  lens(2, 3) = -2 * farthest * view.near / (farthest - view.near);
  lens(3, 2) = 1;
  view.clip_from_world = into_viewport(viewport, picture_width, picture_height) * lens * camera;
  view.pixels_per_unit_at_one = 0.5 * viewport.height / tan_y;
  view.perspective = true;
  view.picture_width = picture_width;
  view.picture_height = picture_height;
  return view;
}

template <>
View frame_all<2>(const Box<2>& box, const CameraChoice<2>& choice, const Viewport& viewport,
                  int picture_width, int picture_height) {
  const Eigen::Vector2d low(box.min[0], box.min[1]);
  const Eigen::Vector2d high(box.max[0], box.max[1]);
  const Eigen::Vector2d extent = (high - low).cwiseMax(1e-9);
  const double aspect = viewport.width / viewport.height;
  const double width = choice.width.value_or(std::max(extent.x(), extent.y() * aspect) / kMargin);
  const Eigen::Vector2d center = choice.center.value_or(0.5 * (low + high));
  View view;
  Eigen::Matrix4d lens = Eigen::Matrix4d::Identity();
  lens(0, 0) = 2 / width;
  lens(1, 1) = 2 * aspect / width;
  lens(0, 3) = -center.x() * lens(0, 0);
  lens(1, 3) = -center.y() * lens(1, 1);
  lens(2, 2) = 0;
  view.clip_from_world = into_viewport(viewport, picture_width, picture_height) * lens;
  view.pixels_per_unit_at_one = viewport.width / width;
  view.picture_width = picture_width;
  view.picture_height = picture_height;
  return view;
}

}  // namespace kerf

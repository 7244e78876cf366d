#include "viz/draw/camera_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

/// A number of the camera: its key, and whether it is interpolated by its logarithm.
struct Number {
  std::string_view key;
  bool by_logarithm = false;
};

template <int D>
std::vector<Number> numbers() {
  if constexpr (D == 2) return {{"center"}, {"center"}, {"width", true}};
  if constexpr (D == 3)
    return {{"yaw"}, {"pitch"}, {"fov"}, {"distance", true}, {"target"}, {"target"}, {"target"}};
}

double number_of(const CameraChoice<2>& camera, std::size_t k) {
  return k < 2 ? (*camera.center)[static_cast<Eigen::Index>(k)] : *camera.width;
}

double number_of(const CameraChoice<3>& camera, std::size_t k) {
  if (k >= 4) return (*camera.target)[static_cast<Eigen::Index>(k - 4)];
  return k == 0 ? camera.yaw : k == 1 ? camera.pitch : k == 2 ? camera.fov : *camera.distance;
}

void set_number(CameraChoice<2>& camera, std::size_t k, double value) {
  if (k == 2) {
    camera.width = value;
    return;
  }
  if (!camera.center) camera.center = Eigen::Vector2d::Zero();
  (*camera.center)[static_cast<Eigen::Index>(k)] = value;
}

void set_number(CameraChoice<3>& camera, std::size_t k, double value) {
  if (k == 0) camera.yaw = value;
  if (k == 1) camera.pitch = value;
  if (k == 2) camera.fov = value;
  if (k == 3) camera.distance = value;
  if (k < 4) return;
  if (!camera.target) camera.target = Eigen::Vector3d::Zero();
  (*camera.target)[static_cast<Eigen::Index>(k - 4)] = value;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool gives(std::string_view camera, std::string_view key) {
  const bool is_angle = key == "yaw" || key == "pitch";
  for (std::string_view rest = camera;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    if (word.substr(0, word.find('=')) == key || (is_angle && is_direction(word))) return true;
    if (comma == std::string_view::npos) return false;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

template <int D>
CameraPath<D>::CameraPath(std::string_view text) : tracks_(numbers<D>().size()) {
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    const std::string_view said = trimmed(line.substr(0, line.find('#')));
    ++number;
    if (!said.empty()) add_line(said, number);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  for (Track& track : tracks_) smooth(track);
}

template <int D>
void CameraPath<D>::add_line(std::string_view line, int number) {
  const std::string where = "line " + std::to_string(number) + ": ";
  double step = 0;
  const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), step);
  const std::string_view camera = trimmed(line.substr(static_cast<std::size_t>(rest - line.data())));
  if (error != std::errc{} || !std::isfinite(step) || step < 0 || camera.empty() ||
      (*rest != ' ' && *rest != '\t'))
    throw std::invalid_argument(where + "\"" + std::string(line) +
                                "\" is not a step and a camera, such as: 120 yaw=90,pitch=20");
  if (step <= last_step_)
    throw std::invalid_argument(where + "step " + std::string(line.data(), rest) +
                                " does not come after the one before it");
  last_step_ = step;
  CameraChoice<D> choice;
  try {
    choice = parse_camera<D>(camera);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(where + wrong.what());
  }
  if (choice.framing == Framing::everything)
    throw std::invalid_argument(where +
                                "\"all\" holds for the whole film: give it to the camera that stands still");
  const std::vector<Number> all = numbers<D>();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!gives(camera, all[k].key)) continue;
    const double value = number_of(choice, k);
    tracks_[k].push_back({step, all[k].by_logarithm ? std::log(value) : value, 0});
  }
}

/// Slopes by Fritsch and Carlson, with the harmonic mean of the neighbours' (Fritsch and Butland 1984): zero
/// where the number turns, so that it never leaves the range of its key frames.
template <int D>
void CameraPath<D>::smooth(Track& track) {
  for (std::size_t i = 1; i + 1 < track.size(); ++i) {
    const double h0 = track[i].step - track[i - 1].step;
    const double h1 = track[i + 1].step - track[i].step;
    const double s0 = (track[i].value - track[i - 1].value) / h0;
    const double s1 = (track[i + 1].value - track[i].value) / h1;
    if (s0 * s1 <= 0) continue;
    const double w0 = 2 * h1 + h0;
    const double w1 = h1 + 2 * h0;
    track[i].slope = (w0 + w1) / (w0 / s0 + w1 / s1);
  }
}

template <int D>
double CameraPath<D>::value_at(const Track& track, double step) {
  const auto next = std::ranges::upper_bound(track, step, {}, &Key::step);
  if (next == track.begin()) return track.front().value;
  if (next == track.end()) return track.back().value;
  const Key& a = *(next - 1);
  const Key& b = *next;
  const double h = b.step - a.step;
  const double t = (step - a.step) / h;
  const double rise = b.value - a.value;
  // Hermite's cubic around the line from a to b.
  return a.value + t * t * (3 - 2 * t) * rise + t * (1 - t) * (1 - t) * h * a.slope -
         t * t * (1 - t) * h * b.slope;
}

template <int D>
CameraChoice<D> CameraPath<D>::at(double step, const CameraChoice<D>& fixed) const {
  CameraChoice<D> camera = fixed;
  const std::vector<Number> all = numbers<D>();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (tracks_[k].empty()) continue;
    const double value = value_at(tracks_[k], step);
    set_number(camera, k, all[k].by_logarithm ? std::exp(value) : value);
  }
  return camera;
}

template class CameraPath<2>;
template class CameraPath<3>;

}  // namespace kerf

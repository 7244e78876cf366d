#include "frames/import/shown_objects.h"

#include <Eigen/Geometry>

#include "core/scene/pose_in_box.h"

namespace kerf {
namespace {

template <int D>
std::array<Vector<D>, D> axes_of(const std::array<double, 4>& turn) {
  using Matrix = Eigen::Matrix<double, D, D>;
  Matrix matrix;
  if constexpr (D == 2) {
    matrix = Eigen::Rotation2Dd(turn[0]).toRotationMatrix();
  } else {
    matrix = Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).toRotationMatrix();
  }
  std::array<Vector<D>, D> axes;
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < D; ++i)
      axes[k].value[i] = static_cast<Scalar>(matrix(static_cast<int>(i), static_cast<int>(k)));
  return axes;
}

}  // namespace

template <int D>
ShownObjects<D>::ShownObjects(const std::vector<GivenObject<D>>& given, const std::string& name,
                              const Survey& survey, Oddities& oddities) {
  for (const GivenObject<D>& one : given) {
    const auto object = survey.find(one.object);
    if (!object) {
      oddities.note(Oddity::unknown_object, [&] {
        return name + ", line " + std::to_string(one.line) + ": object " + to_string(one.object);
      });
      continue;
    }
    if (one.mark != ObjectMark()) marks_.set(*object, one.mark);
    if (one.shape) shapes_.emplace(*object, Shown{*one.shape});
  }
}

template <int D>
bool ShownObjects<D>::place(ObjectId object, const Box<D>& box,
                            const std::optional<std::array<double, 4>>& turn) {
  const auto found = shapes_.find(object);
  if (found == shapes_.end()) return true;
  Shown& shown = found->second;
  const bool is_turned = D == 2 || !is_ball<D>(shown.shape);
  if (turn && is_turned) shown.turn = turn_of<D>(axes_of<D>(*turn));
  shown.fits = pose_in_box<D>(shown.shape, kerf::axes_of(shown.turn), box).has_value();
  return shown.fits;
}

template <int D>
Appearance<D> ShownObjects<D>::appearance(ObjectId object) const {
  const auto found = shapes_.find(object);
  if (found == shapes_.end() || !found->second.fits) return {};
  return {&found->second.shape, found->second.turn, std::nullopt};
}

template class ShownObjects<2>;
template class ShownObjects<3>;

}  // namespace kerf

#include "viz/debugger/model/object_course.h"

#include <cmath>
#include <limits>

#include "core/geometry/plane.h"
#include "core/replay/replayer.h"

namespace kerf {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// The leaves that the object's volume reaches, which are those that hold it.
template <int D>
std::uint32_t count_leaves_with(const Tree<D>& tree, ObjectId object) {
  std::uint32_t leaves = 0;
  std::vector<NodeId> todo{tree.root()};
  while (!todo.empty()) {
    const Node<D>& node = tree[todo.back()];
    todo.pop_back();
    if (node.is_leaf()) {
      ++leaves;
      continue;
    }
    const Sides sides = classify(tree.project(node.direction, object), node.plane.offset);
    if (sides.left) todo.push_back(node.left);
    if (sides.right) todo.push_back(node.right);
  }
  return leaves;
}

template <int D>
std::uint32_t count_pairs_with(const ObjectTable<D>& table, ObjectId object) {
  std::uint32_t pairs = 0;
  for (std::uint32_t k = 0; k < table.bound(); ++k) {
    const ObjectId other{k};
    if (other != object && table.is_placed(other) && table.is_pair(object, other)) ++pairs;
  }
  return pairs;
}

template <int D>
float way_between(const Vector<D>& a, const Vector<D>& b) {
  double square = 0;
  for (int axis = 0; axis < D; ++axis) {
    const double way = double{b[axis]} - double{a[axis]};
    square += way * way;
  }
  return static_cast<float>(std::sqrt(square));
}

}  // namespace

template <int D>
ObjectCourse find_course(RecordingReader<D>& recording, ObjectId object,
                         const std::function<bool(std::uint32_t)>& goes_on) {
  const std::vector<float> none(recording.steps(), kNoValue);
  ObjectCourse course{none, none, none};
  Bsp<D, Watch> tree(recording.info().config, recording.info().volume);
  tree.decide(recording.info().decisions);
  Vector<D> last{};
  bool was_there = false;
  for (std::uint32_t step = 1; step <= recording.steps(); ++step) {
    if (goes_on && !goes_on(step)) break;
    run_recorded_step(recording, tree, false);
    const ObjectTable<D>& table = tree.objects();
    if (!table.is_placed(object)) {
      was_there = false;
      continue;
    }
    const Vector<D> now = table.box(object).center();
    course.leaves[step - 1] = static_cast<float>(count_leaves_with(tree.tree(), object));
    course.pairs[step - 1] = static_cast<float>(count_pairs_with(table, object));
    if (was_there) course.speed[step - 1] = way_between<D>(last, now);
    was_there = true;
    last = now;
  }
  return course;
}

template ObjectCourse find_course<2>(RecordingReader<2>&, ObjectId,
                                     const std::function<bool(std::uint32_t)>&);
template ObjectCourse find_course<3>(RecordingReader<3>&, ObjectId,
                                     const std::function<bool(std::uint32_t)>&);

}  // namespace kerf

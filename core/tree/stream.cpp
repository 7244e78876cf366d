#include "core/tree/stream.h"

#include <utility>

namespace kerf {
namespace {

/// A node and where its list lies: [begin, end) of the buffer.
struct Range {
  NodeId node;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Calls `work` with the function that gives an object's interval along a direction: a look into the packed
/// boxes where the direction is an axis of them.
template <int D, class Work>
void with_intervals(const Tree<D>& tree, std::uint32_t direction, Work work) {
  if (direction >= D || tree.table.kind() != VolumeKind::box) {
    work([&](std::uint32_t object) { return tree.project(direction, ObjectId{object}); });
    return;
  }
  work([boxes = tree.table.packed().data(), direction](std::uint32_t object) {
    const auto& lane = boxes[object].lane;
    return Interval{lane[direction], -lane[PackedBox<D>::kHalf + direction]};
  });
}

template <int D>
class Streamer {
 public:
  Streamer(Tree<D>& tree, StreamBuffer& buffer) : tree_(tree), buffer_(buffer) {}

  void run() {
    std::vector<Range> todo{{tree_.root(), 0, list_all()}};
    while (!todo.empty()) {
      const Range range = todo.back();
      todo.pop_back();
      Node<D>& node = tree_[range.node];
      node.population = static_cast<std::uint32_t>(range.end - range.begin);
      if (node.is_leaf()) {
        fill(range);
      } else {
        divide(node, range, todo);
      }
    }
  }

 private:
  void make_room(std::size_t size) {
    if (size <= buffer_.objects.size()) return;
    buffer_.objects.resize(2 * size);
    buffer_.straddle.resize(2 * size);
  }

  std::size_t list_all() {
    const auto bound = static_cast<std::uint32_t>(tree_.table.bound());
    make_room(bound);
    std::size_t count = 0;
    for (std::uint32_t id = 0; id < bound; ++id) {
      buffer_.objects[count] = id;
      buffer_.straddle[count] = 0;
      count += tree_.table.is_placed({id}) ? 1 : 0;
    }
    return count;
  }

  /// Keeps what lies left at the list's place and writes what lies right behind its end. The right child is
  /// done first: nothing but dead lists lies behind the left one then. No branch depends on the sides.
  void divide(const Node<D>& node, const Range& range, std::vector<Range>& todo) {
    make_room(range.end + (range.end - range.begin));
    std::uint32_t* const objects = buffer_.objects.data();
    DepthMask* const straddle = buffer_.straddle.data();
    const unsigned depth = node.depth;
    const Scalar offset = node.plane.offset;
    std::size_t left = range.begin;
    std::size_t right = range.end;
    with_intervals(tree_, node.direction, [&](auto interval_of) {
      for (std::size_t k = range.begin; k < range.end; ++k) {
        const std::uint32_t object = objects[k];
        const Sides sides = classify(interval_of(object), offset);
        const DepthMask mask = straddle[k] | (static_cast<DepthMask>(sides.left & sides.right) << depth);
        objects[left] = object;
        straddle[left] = mask;
        left += sides.left ? 1 : 0;
        objects[right] = object;
        straddle[right] = mask;
        right += sides.right ? 1 : 0;
      }
    });
    todo.push_back({node.left, range.begin, left});
    todo.push_back({node.right, range.end, right});
  }

  void fill(const Range& range) {
    std::vector<Entry>& entries = tree_.refill(range.node, range.end - range.begin);
    with_intervals(tree_, tree_[range.node].direction, [&](auto interval_of) {
      for (std::size_t k = 0; k < entries.size(); ++k) {
        const std::uint32_t object = buffer_.objects[range.begin + k];
        entries[k] = {interval_of(object), ObjectId{object}, buffer_.straddle[range.begin + k]};
      }
    });
  }

  Tree<D>& tree_;
  StreamBuffer& buffer_;
};

}  // namespace

template <int D>
void stream(Tree<D>& tree, StreamBuffer& buffer) {
  Streamer<D>(tree, buffer).run();
}

template void stream<2>(Tree<2>&, StreamBuffer&);
template void stream<3>(Tree<3>&, StreamBuffer&);

}  // namespace kerf

#include "core/tree/stream.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/kernels/divide_list.h"
#include "core/kernels/prefetch.h"

namespace kerf {
namespace {

/// A node and where its list lies: [begin, end) of the buffer.
struct Range {
  NodeId node;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Whether the packed boxes tell an object's interval along a direction.
template <int D>
bool lies_along_axis(const Tree<D>& tree, std::uint32_t direction) {
  return direction < D && tree.table.kind() == VolumeKind::box;
}

/// Calls `work` with the function that gives an object's interval along a direction: a look into the packed
/// boxes where the direction is an axis of them.
template <int D, class Work>
void with_intervals(const Tree<D>& tree, std::uint32_t direction, Work work) {
  if (!lies_along_axis(tree, direction)) {
    work([&](std::uint32_t object) { return tree.project(direction, ObjectId{object}); });
    return;
  }
  work([boxes = tree.table.packed().data(), direction](std::uint32_t object) {
    const auto& lane = boxes[object].lane;
    return Interval{lane[direction], -lane[PackedBox<D>::kHalf + direction]};
  });
}

void make_room(StreamBuffer& buffer, std::size_t size) {
  if (size <= buffer.objects.size()) return;
  const std::size_t room = size + size / 8;
  buffer.objects.reserve(room);  // no more than that
  buffer.straddle.reserve(room);
  buffer.objects.resize(room);
  buffer.straddle.resize(room);
}

/// Gives back what a list of everybody needed, when lists are short.
void give_back(StreamMemory& memory, std::size_t listed) {
  constexpr std::size_t kManyTimes = 8;
  for (StreamBuffer& buffer : memory.by_thread)
    if (buffer.objects.size() > kManyTimes * (listed + kDividePad)) buffer = {};
}

/// All placed objects of a table, to be sent down.
template <int D>
struct Everybody {
  const ObjectTable<D>& table;

  [[nodiscard]] std::size_t size() const { return table.bound(); }
  /// Makes the list of those with an id in the slice; gives their number.
  std::size_t list(const Slice& ids, StreamBuffer& buffer) const {
    make_room(buffer, ids.end - ids.begin);
    std::size_t count = 0;
    for (std::size_t id = ids.begin; id < ids.end; ++id) {
      buffer.objects[count] = static_cast<std::uint32_t>(id);
      buffer.straddle[count] = 0;
      count += table.is_placed({static_cast<std::uint32_t>(id)}) ? 1 : 0;
    }
    return count;
  }
};

/// Some objects, to be sent down.
struct Some {
  std::span<const std::uint32_t> objects;

  [[nodiscard]] std::size_t size() const { return objects.size(); }
  std::size_t list(const Slice& slice, StreamBuffer& buffer) const {
    const std::size_t count = slice.end - slice.begin;
    make_room(buffer, count);
    std::copy_n(objects.begin() + static_cast<std::ptrdiff_t>(slice.begin), count, buffer.objects.begin());
    std::fill_n(buffer.straddle.begin(), count, 0);
    return count;
  }
};

/// Sends one list down, in its own buffer.
template <int D>
class Streamer {
 public:
  Streamer(const Tree<D>& tree, StreamBuffer& buffer) : tree_(tree), buffer_(buffer) {}

  /// Puts what parts left for their k-th end behind one another.
  std::size_t gather(const std::vector<StreamPart>& parts, std::size_t k) {
    std::size_t count = 0;
    for (const StreamPart& part : parts) {
      const StreamPart::Stretch& from = part.ends[k];
      make_room(buffer_, count + from.end - from.begin);
      std::copy(part.arrived.objects.begin() + at(from.begin), part.arrived.objects.begin() + at(from.end),
                buffer_.objects.begin() + at(count));
      std::copy(part.arrived.straddle.begin() + at(from.begin), part.arrived.straddle.begin() + at(from.end),
                buffer_.straddle.begin() + at(count));
      count += from.end - from.begin;
    }
    return count;
  }
  /// Sends the first `count` of the list down; below a node go on those of which `visit(range)` says so.
  template <class Visit>
  void run(NodeId from, std::size_t count, Visit visit) {
    std::vector<Range> todo{{from, 0, count}};
    while (!todo.empty()) {
      const Range range = todo.back();
      todo.pop_back();
      if (visit(range)) divide(tree_[range.node], range, todo);
    }
  }

 private:
  static std::ptrdiff_t at(std::size_t k) { return static_cast<std::ptrdiff_t>(k); }

  /// Keeps what lies left at the list's place and writes what lies right behind its end. The right child is
  /// done first: nothing but dead lists lies behind the left one then. No branch depends on the sides.
  void divide(const Node<D>& node, const Range& range, std::vector<Range>& todo) {
    make_room(buffer_, range.end + (range.end - range.begin) + kDividePad);
    std::uint32_t* const objects = buffer_.objects.data();
    DepthMask* const straddle = buffer_.straddle.data();
    const unsigned depth = node.depth;
    const Scalar offset = node.plane.offset;
    const Divided done = divide_vectors(node, range);
    std::size_t left = done.left;
    std::size_t right = done.right;
    with_intervals(tree_, node.direction, [&](auto interval_of) {
      for (std::size_t k = done.done; k < range.end; ++k) {
        prefetch(&tree_.table.packed({objects[std::min(k + kPrefetchAhead, range.end - 1)]}));
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

  /// What vectors can do of it: nothing unless the partitioner lies along an axis of the packed boxes.
  Divided divide_vectors(const Node<D>& node, const Range& range) {
    if (range.begin == range.end || !lies_along_axis(tree_, node.direction))
      return {range.begin, range.begin, range.end};
    const auto& first = tree_.table.packed().data()->lane;
    return divide_list<D>({&first[node.direction], &first[PackedBox<D>::kHalf + node.direction],
                           node.plane.offset, depth_bit(node.depth), buffer_.objects.data(),
                           buffer_.straddle.data(), range.begin, range.end,
                           exceeds(tree_.table.packed(), kOwnCache)});
  }

  const Tree<D>& tree_;
  StreamBuffer& buffer_;
};

/// Writes the entries of those that came into a leaf, behind those that stayed there.
template <int D>
void fill(Tree<D>& tree, const Range& range, std::size_t stayed, const StreamBuffer& buffer) {
  const std::size_t came = range.end - range.begin;
  Entry* const entries = tree.refill(range.node, stayed + came).data() + stayed;
  with_intervals(tree, tree[range.node].direction, [&](auto interval_of) {
    for (std::size_t k = 0; k < came; ++k) {
      const std::uint32_t object = buffer.objects[range.begin + k];
      entries[k] = {interval_of(object), ObjectId{object}, buffer.straddle[range.begin + k]};
    }
  });
}

/// Sends the first `count` of the streamer's list down to the leaves. `stayed`: who is below each node
/// already.
template <int D>
void finish(Tree<D>& tree, NodeId from, std::size_t count, const std::vector<std::uint32_t>& stayed,
            Streamer<D>& streamer, const StreamBuffer& buffer) {
  streamer.run(from, count, [&](const Range& range) {
    const std::uint32_t before = stayed[range.node.index()];
    tree[range.node].population = before + static_cast<std::uint32_t>(range.end - range.begin);
    if (tree[range.node].is_leaf()) fill(tree, range, before, buffer);
    return !tree[range.node].is_leaf();
  });
}

/// The least depth at which the tree falls into that many parts, or its height.
template <int D>
std::uint32_t depth_of_parts(const Tree<D>& tree, std::size_t least) {
  std::vector<NodeId> level{tree.root()};
  std::uint32_t depth = 0;
  for (std::size_t leaves = 0; !level.empty() && level.size() + leaves < least; ++depth) {
    std::vector<NodeId> next;
    for (const NodeId id : level) {
      if (tree[id].is_leaf()) {
        ++leaves;
      } else {
        next.insert(next.end(), {tree[id].left, tree[id].right});
      }
    }
    level = std::move(next);
  }
  return depth;
}

/// Sends a piece of the objects down to the given depth: the first `count` of the buffer.
template <int D>
void stream_part(const Tree<D>& tree, std::size_t count, std::uint32_t depth, StreamBuffer& buffer,
                 StreamPart& part) {
  part.ends.clear();
  part.passed.clear();
  part.arrived.objects.clear();
  part.arrived.straddle.clear();
  Streamer<D> streamer(tree, buffer);
  streamer.run(tree.root(), count, [&](const Range& range) {
    const Node<D>& node = tree[range.node];
    if (!node.is_leaf() && node.depth < depth) {
      part.passed.emplace_back(range.node, range.end - range.begin);
      return true;
    }
    const std::size_t begin = part.arrived.objects.size();
    const auto copy = [&range](const auto& from, auto& to) {
      to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(range.begin),
                from.begin() + static_cast<std::ptrdiff_t>(range.end));
    };
    copy(buffer.objects, part.arrived.objects);
    copy(buffer.straddle, part.arrived.straddle);
    part.ends.push_back({range.node, begin, part.arrived.objects.size()});
    return false;
  });
}

template <int D, class Objects>
void stream_in_parts(Tree<D>& tree, const Objects& objects, const std::vector<std::uint32_t>& stayed,
                     StreamMemory& memory, TaskPool& pool) {
  memory.parts.resize(pool.pieces());
  const std::uint32_t depth = depth_of_parts(tree, pool.pieces());
  pool.for_each(memory.parts.size(), [&](std::size_t piece, std::size_t thread) {
    StreamBuffer& buffer = memory.by_thread[thread];
    const std::size_t count = objects.list(slice(objects.size(), memory.parts.size(), piece), buffer);
    stream_part(tree, count, depth, buffer, memory.parts[piece]);
  });
  for (const auto& [node, count] : memory.parts.front().passed) tree[node].population = stayed[node.index()];
  for (const StreamPart& part : memory.parts)
    for (const auto& [node, count] : part.passed) tree[node].population += count;
  const std::vector<StreamPart::Stretch>& ends = memory.parts.front().ends;
  pool.for_each(ends.size(), [&](std::size_t k, std::size_t thread) {
    StreamBuffer& buffer = memory.by_thread[thread];
    Streamer<D> streamer(tree, buffer);
    finish(tree, ends[k].node, streamer.gather(memory.parts, k), stayed, streamer, buffer);
  });
}

template <int D, class Objects>
void send_down(Tree<D>& tree, const Objects& objects, const std::vector<std::uint32_t>& stayed,
               StreamMemory& memory, TaskPool& pool) {
  memory.by_thread.resize(pool.threads());
  if (pool.threads() == 1) {
    StreamBuffer& buffer = memory.by_thread.front();
    const std::size_t count = objects.list({0, objects.size()}, buffer);
    Streamer<D> streamer(tree, buffer);
    finish(tree, tree.root(), count, stayed, streamer, buffer);
  } else {
    stream_in_parts(tree, objects, stayed, memory, pool);
  }
  tree.count_entries();
}

}  // namespace

template <int D>
void stream(Tree<D>& tree, StreamMemory& memory, TaskPool& pool) {
  memory.nobody.assign(tree.slots(), 0);
  send_down(tree, Everybody<D>{tree.table}, memory.nobody, memory, pool);
}

template <int D>
void stream(Tree<D>& tree, const LeavePass<D>& pass, StreamMemory& memory, TaskPool& pool) {
  give_back(memory, pass.leavers().size());
  send_down(tree, Some{pass.leavers()}, pass.stayed(), memory, pool);
}

#define KERF_INSTANTIATE(D)                                    \
  template void stream<D>(Tree<D>&, StreamMemory&, TaskPool&); \
  template void stream<D>(Tree<D>&, const LeavePass<D>&, StreamMemory&, TaskPool&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

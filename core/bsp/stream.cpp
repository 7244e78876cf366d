#include "core/bsp/stream.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/list_room.h"
#include "core/base/short_stack.h"
#include "core/base/tuning.h"
#include "core/kernels/divide_list.h"
#include "core/kernels/prefetch.h"

namespace kerf {
namespace {

/// Whether the packed boxes have an object's interval along a direction.
template <int D>
bool lies_along_axis(const Tree<D>& tree, std::uint32_t direction) {
  return direction < D && tree.table.kind() == VolumeKind::box;
}

/// Calls `work` with the function from a place among `objects` to the object's interval along a direction: a
/// read of the packed boxes where the direction is one of their axes.
template <int D, class Objects, class Work>
void with_intervals(const Tree<D>& tree, const Objects& objects, std::uint32_t direction, Work work) {
  if (!lies_along_axis(tree, direction)) {
    work([&](std::uint32_t place) { return tree.project(direction, objects.at(place)); });
    return;
  }
  work([boxes = objects.boxes().data(), direction](std::uint32_t place) {
    const auto& lane = boxes[place].lane;
    return Interval{lane[direction], -lane[PackedBox<D>::kHalf + direction]};
  });
}

void make_room(StreamBuffer& buffer, std::size_t size) {
  if (size <= buffer.places.size()) return;
  const std::size_t room = list_room(size);
  buffer.places.reserve(room);  // no more than that
  buffer.straddle.reserve(room);
  buffer.places.resize(room);
  buffer.straddle.resize(room);
}

/// Gives memory back that a list of all objects needed, when lists are short.
void give_back(StreamMemory& memory, std::size_t listed) {
  for (StreamBuffer& buffer : memory.by_thread)
    if (buffer.places.size() > tuning::kListExcess * (listed + kDividePad)) buffer = {};
}

/// Objects whose places are their ids.
template <int D>
struct ById {
  const ObjectTable<D>& table;

  [[nodiscard]] ObjectId at(std::uint32_t place) const { return {place}; }
  [[nodiscard]] std::span<const PackedBox<D>> boxes() const { return table.packed(); }
};

/// All placed objects of a table, to be sent down.
template <int D>
struct AllPlacedObjects : ById<D> {
  using ById<D>::table;

  [[nodiscard]] std::size_t size() const { return table.bound(); }
  /// Makes the list of the objects with an id in the slice. Returns their number.
  std::size_t list(const Slice& ids, StreamBuffer& buffer) const {
    make_room(buffer, ids.end - ids.begin);
    std::size_t count = 0;
    for (std::size_t id = ids.begin; id < ids.end; ++id) {
      buffer.places[count] = static_cast<std::uint32_t>(id);
      buffer.straddle[count] = 0;
      count += table.is_placed({static_cast<std::uint32_t>(id)}) ? 1 : 0;
    }
    return count;
  }
};

/// Some objects of a table, to be sent down.
template <int D>
struct Some : ById<D> {
  std::span<const std::uint32_t> ids;

  [[nodiscard]] std::size_t size() const { return ids.size(); }
  std::size_t list(const Slice& slice, StreamBuffer& buffer) const {
    const std::size_t count = slice.end - slice.begin;
    make_room(buffer, count);
    std::copy_n(ids.begin() + static_cast<std::ptrdiff_t>(slice.begin), count, buffer.places.begin());
    std::fill_n(buffer.straddle.begin(), count, 0);
    return count;
  }
};

/// The objects that left their leaves, to be sent down, by their places in the pass. Objects of neighbouring
/// leaves have neighbouring places, and most go to a leaf nearby, so that a list reads their boxes nearly in
/// order.
template <int D>
struct Leavers {
  const LeaverPass<D>& pass;

  [[nodiscard]] std::size_t size() const { return pass.leavers().size(); }
  [[nodiscard]] ObjectId at(std::uint32_t place) const { return {pass.leavers()[place]}; }
  [[nodiscard]] std::span<const PackedBox<D>> boxes() const { return pass.leaver_boxes(); }
  std::size_t list(const Slice& slice, StreamBuffer& buffer) const {
    const std::size_t count = slice.end - slice.begin;
    make_room(buffer, count);
    std::iota(buffer.places.begin(), buffer.places.begin() + static_cast<std::ptrdiff_t>(count),
              static_cast<std::uint32_t>(slice.begin));
    std::fill_n(buffer.straddle.begin(), count, 0);
    return count;
  }
};

/// Sends one list down, in its own buffer.
template <int D, class Objects>
class Streamer {
 public:
  Streamer(const Tree<D>& tree, const Objects& objects, StreamBuffer& buffer)
      : tree_(tree), objects_(objects), buffer_(buffer) {}

  /// Joins what the parts have for their k-th end.
  std::size_t gather(const std::vector<StreamPart>& parts, std::size_t k) {
    std::size_t count = 0;
    for (const StreamPart& part : parts) {
      const StreamRange& from = part.ends[k];
      make_room(buffer_, count + from.end - from.begin);
      std::copy(part.arrived.places.begin() + at(from.begin), part.arrived.places.begin() + at(from.end),
                buffer_.places.begin() + at(count));
      std::copy(part.arrived.straddle.begin() + at(from.begin), part.arrived.straddle.begin() + at(from.end),
                buffer_.straddle.begin() + at(count));
      count += from.end - from.begin;
    }
    return count;
  }
  /// Sends the first `count` objects of the list down. `visit(range)` returns whether a list goes on below
  /// its node.
  template <class Visit>
  void run(NodeId from, std::size_t count, Visit visit) {
    ShortStack<StreamRange> todo({from, 0, count});
    while (!todo.empty()) {
      const StreamRange range = todo.pop();
      if (visit(range)) divide(tree_[range.node], range, todo);
    }
  }

 private:
  static std::ptrdiff_t at(std::size_t k) { return static_cast<std::ptrdiff_t>(k); }

  /// Keeps the left objects at the list's place and writes the right ones behind its end. The right child is
  /// done first: nothing but dead lists lies behind the left one then. No branch depends on the sides.
  void divide(const Node<D>& node, const StreamRange& range, ShortStack<StreamRange>& todo) {
    make_room(buffer_, range.end + (range.end - range.begin) + kDividePad);
    std::uint32_t* const places = buffer_.places.data();
    DepthMask* const straddle = buffer_.straddle.data();
    const unsigned depth = node.depth;
    const Scalar offset = node.plane.offset;
    const Divided done = divide_vectors(node, range);
    std::size_t left = done.left;
    std::size_t right = done.right;
    with_intervals<D>(tree_, objects_, node.direction, [&](auto interval_of) {
      for (std::size_t k = done.done; k < range.end; ++k) {
        prefetch(&objects_.boxes()[places[std::min(k + tuning::kPrefetchAhead, range.end - 1)]]);
        const std::uint32_t place = places[k];
        const Sides sides = classify(interval_of(place), offset);
        const DepthMask mask = straddle[k] | (static_cast<DepthMask>(sides.left & sides.right) << depth);
        places[left] = place;
        straddle[left] = mask;
        left += sides.left ? 1 : 0;
        places[right] = place;
        straddle[right] = mask;
        right += sides.right ? 1 : 0;
      }
    });
    todo.push({node.left, range.begin, left});
    todo.push({node.right, range.end, right});
  }

  /// The part of it that vectors can do: nothing unless the partitioner lies along an axis of the packed
  /// boxes, and a signed index of 32 bits reaches each of their floats.
  Divided divide_vectors(const Node<D>& node, const StreamRange& range) {
    constexpr std::size_t kMostBoxes = (std::size_t{1} << 31U) / (2 * PackedBox<D>::kHalf);
    if (range.begin == range.end || !lies_along_axis(tree_, node.direction) ||
        objects_.boxes().size() > kMostBoxes)
      return {range.begin, range.begin, range.end};
    const auto& first = objects_.boxes().data()->lane;
    return divide_list<D>({&first[node.direction], &first[PackedBox<D>::kHalf + node.direction],
                           node.plane.offset, depth_bit(node.depth), buffer_.places.data(),
                           buffer_.straddle.data(), range.begin, range.end,
                           exceeds(objects_.boxes(), tuning::kOwnCache)});
  }

  const Tree<D>& tree_;
  const Objects& objects_;
  StreamBuffer& buffer_;
};

/// What all lists share that are placed.
template <int D, class Objects>
struct Placing {
  Tree<D>& tree;
  const Objects& objects;
  const std::vector<std::uint32_t>& stayed;  ///< number of objects that are below each node already
  LeafBoxes<D>& boxes;
};

/// Writes the entries of objects that came into a leaf, behind those that stayed there.
template <int D, class Objects>
void fill(const Placing<D, Objects>& to, const StreamRange& range, std::size_t stayed,
          const StreamBuffer& buffer) {
  const std::size_t came = range.end - range.begin;
  const std::uint32_t* const places = buffer.places.data() + range.begin;
  const DepthMask* const straddle = buffer.straddle.data() + range.begin;
  Entry* const entries = to.tree.refill(range.node, stayed + came).data() + stayed;
  with_intervals<D>(to.tree, to.objects, to.tree[range.node].direction, [&](auto interval_of) {
    for (std::size_t k = 0; k < came; ++k)
      entries[k] = {interval_of(places[k]), to.objects.at(places[k]), straddle[k]};
  });
  if (!to.boxes.wanted()) return;
  PackedBox<D>* const boxes = to.boxes.refill(range.node, stayed + came).data() + stayed;
  for (std::size_t k = 0; k < came; ++k) boxes[k] = to.objects.boxes()[places[k]];
  to.boxes.finish(to.tree, range.node);
}

/// Sends the first `count` objects of the streamer's list down to the leaves.
template <int D, class Objects>
void finish(const Placing<D, Objects>& to, NodeId from, std::size_t count, Streamer<D, Objects>& streamer,
            const StreamBuffer& buffer) {
  streamer.run(from, count, [&](const StreamRange& range) {
    const std::uint32_t before = to.stayed[range.node.index()];
    Node<D>& node = to.tree[range.node];
    node.population = before + static_cast<std::uint32_t>(range.end - range.begin);
    if (node.is_leaf()) fill(to, range, before, buffer);
    return !node.is_leaf();
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

/// Sends a piece of the objects, the first `count` of the buffer, down to the given depth.
template <int D, class Objects>
void stream_part(const Tree<D>& tree, const Objects& objects, std::size_t count, std::uint32_t depth,
                 StreamBuffer& buffer, StreamPart& part) {
  part.ends.clear();
  part.passed.clear();
  part.arrived.places.clear();
  part.arrived.straddle.clear();
  Streamer<D, Objects> streamer(tree, objects, buffer);
  streamer.run(tree.root(), count, [&](const StreamRange& range) {
    const Node<D>& node = tree[range.node];
    if (!node.is_leaf() && node.depth < depth) {
      part.passed.emplace_back(range.node, range.end - range.begin);
      return true;
    }
    const std::size_t begin = part.arrived.places.size();
    const auto copy = [&range](const auto& from, auto& to) {
      to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(range.begin),
                from.begin() + static_cast<std::ptrdiff_t>(range.end));
    };
    copy(buffer.places, part.arrived.places);
    copy(buffer.straddle, part.arrived.straddle);
    part.ends.push_back({range.node, begin, part.arrived.places.size()});
    return false;
  });
}

template <int D, class Objects>
void stream_in_parts(const Placing<D, Objects>& to, StreamMemory& memory, TaskPool& pool) {
  memory.parts.resize(pool.pieces());
  const std::uint32_t depth = depth_of_parts(to.tree, pool.pieces());
  pool.for_each(memory.parts.size(), [&](std::size_t piece, std::size_t thread) {
    StreamBuffer& buffer = memory.by_thread[thread];
    const Slice some = slice(to.objects.size(), memory.parts.size(), piece);
    stream_part(to.tree, to.objects, to.objects.list(some, buffer), depth, buffer, memory.parts[piece]);
  });
  for (const auto& [node, count] : memory.parts.front().passed)
    to.tree[node].population = to.stayed[node.index()];
  for (const StreamPart& part : memory.parts)
    for (const auto& [node, count] : part.passed) to.tree[node].population += count;
  const std::vector<StreamRange>& ends = memory.parts.front().ends;
  pool.for_each(ends.size(), [&](std::size_t k, std::size_t thread) {
    StreamBuffer& buffer = memory.by_thread[thread];
    Streamer<D, Objects> streamer(to.tree, to.objects, buffer);
    finish(to, ends[k].node, streamer.gather(memory.parts, k), streamer, buffer);
  });
}

template <int D, class Objects>
void send_down(const Placing<D, Objects>& to, StreamMemory& memory, TaskPool& pool) {
  memory.by_thread.resize(std::max<std::size_t>(memory.by_thread.size(), pool.threads()));
  if (pool.threads() == 1) {
    StreamBuffer& buffer = memory.by_thread.front();
    const std::size_t count = to.objects.list({0, to.objects.size()}, buffer);
    Streamer<D, Objects> streamer(to.tree, to.objects, buffer);
    finish(to, to.tree.root(), count, streamer, buffer);
  } else {
    stream_in_parts(to, memory, pool);
  }
  to.tree.count_entries();
}

}  // namespace

template <int D>
void stream(Tree<D>& tree, LeafBoxes<D>& boxes, StreamMemory& memory, TaskPool& pool) {
  memory.none_stay.assign(tree.slots(), 0);
  const AllPlacedObjects<D> all{{tree.table}};
  send_down(Placing<D, AllPlacedObjects<D>>{tree, all, memory.none_stay, boxes}, memory, pool);
}

template <int D>
void stream(Tree<D>& tree, const LeaverPass<D>& pass, LeafBoxes<D>& boxes, StreamMemory& memory,
            TaskPool& pool) {
  give_back(memory, pass.leavers().size());
  const Some<D> by_id{{tree.table}, pass.leavers()};
  const Leavers<D> by_place{pass};
  if (boxes.wanted()) {
    send_down(Placing<D, Leavers<D>>{tree, by_place, pass.stayed(), boxes}, memory, pool);
  } else {
    send_down(Placing<D, Some<D>>{tree, by_id, pass.stayed(), boxes}, memory, pool);
  }
}

#define KERF_INSTANTIATE(D)                                                   \
  template void stream<D>(Tree<D>&, LeafBoxes<D>&, StreamMemory&, TaskPool&); \
  template void stream<D>(Tree<D>&, const LeaverPass<D>&, LeafBoxes<D>&, StreamMemory&, TaskPool&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

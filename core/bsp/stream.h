#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/task_pool.h"
#include "core/bsp/leaf_boxes.h"
#include "core/bsp/leave.h"
#include "core/tree/tree.h"

namespace kerf {

/// A list of objects, by their places among the objects that are sent down, and what they straddle so far.
struct StreamBuffer {
  std::vector<std::uint32_t> places;
  std::vector<DepthMask> straddle;
};

/// A node and where its list lies: [begin, end) of a buffer.
struct StreamRange {
  NodeId node;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// One piece of the objects where it leaves the upper part of the tree.
struct StreamPart {
  StreamBuffer arrived;
  std::vector<StreamRange> ends;                         ///< where they lie in `arrived`
  std::vector<std::pair<NodeId, std::uint32_t>> passed;  ///< number of objects that passed each node above
};

/// Memory of `stream`, kept between steps.
struct StreamMemory {
  std::vector<StreamBuffer> by_thread;
  std::vector<StreamPart> parts;
  std::vector<std::uint32_t> none_stay;  ///< by node: 0 objects stay below it
};

/// Places all objects of the table anew in one pass down the tree: each node divides the list of its objects
/// for its children. It has none of the mispredicted branches of a walk for each object, and the lists soon
/// fit in the nearest cache. It pays when many objects have left their leaves. The structure of the tree and
/// its partitioners stay. Threads take pieces of the objects through the upper part of the tree, then whole
/// subtrees; the lists are the same for any number of threads.
///
/// If boxes are wanted, `boxes` has those of all leaves afterwards.
///
/// Pre: the tree's table has the volumes by which all objects are to be placed; entries may be of others.
template <int D>
void stream(Tree<D>& tree, LeafBoxes<D>& boxes, StreamMemory& memory, TaskPool& pool);
/// The same for the objects that left their leaves in the pass; the others stay.
template <int D>
void stream(Tree<D>& tree, const LeaverPass<D>& pass, LeafBoxes<D>& boxes, StreamMemory& memory,
            TaskPool& pool);

}  // namespace kerf

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/config.h"
#include "core/base/task_pool.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/leave.h"
#include "core/bsp/requests.h"
#include "core/bsp/stream.h"
#include "core/bsp/thread_use.h"
#include "core/tree/tree.h"

namespace kerf {

/// Objects that come into the tree in a step, in ascending order, and objects that leave it.
struct Traffic {
  std::vector<ObjectId> came;
  std::vector<ObjectId> gone;
};

/// The memory of the passes of a step, kept between steps.
template <int D>
struct StepMemory {
  LeafPass<D> leaf_pass;
  Traffic traffic;
  LeaverPass<D> leaver_pass;
  StreamMemory stream_memory;
};

/// What the three strategies of a step (OrderedStep, SweptStep, KeptStep) work on.
template <int D>
struct StepContext {
  const Config& config;
  Tree<D>& tree;
  Requests<D>& requests;
  StepMemory<D>& memory;
  const ThreadUse& threads;
  std::uint32_t number;              ///< of the step
  std::optional<Vector<D>> shift{};  ///< by which nearly all objects moved

  [[nodiscard]] TaskPool& pool() const { return threads.pool(); }
};

}  // namespace kerf

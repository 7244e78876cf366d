#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frames/sequence/farm/worker.h"

namespace kerf {

/// Memory shared with processes forked later, cut into slots of equal size. Unused pages take no memory.
class SharedSlots {
 public:
  /// Each slot has at least `least_bytes`, and much more if the system allows. Throws std::runtime_error.
  SharedSlots(std::size_t count, std::size_t least_bytes);
  ~SharedSlots();
  SharedSlots(const SharedSlots&) = delete;
  SharedSlots& operator=(const SharedSlots&) = delete;

  [[nodiscard]] const std::vector<SlotMemory>& slots() const { return slots_; }

 private:
  void* memory_ = nullptr;
  std::size_t size_ = 0;
  std::vector<SlotMemory> slots_;
};

}  // namespace kerf

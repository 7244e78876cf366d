#include "frames/sequence/farm/shared_slots.h"

#include <sys/mman.h>

#include <algorithm>
#include <stdexcept>

namespace kerf {

SharedSlots::SharedSlots(std::size_t count, std::size_t least_bytes) {
  constexpr std::size_t kPage = 4096;
  constexpr std::size_t kPlenty = std::size_t{512} << 20U;
  const std::size_t least = (least_bytes + kPage - 1) / kPage * kPage;
  memory_ = MAP_FAILED;
  std::size_t each = std::max(least, kPlenty);
  for (; memory_ == MAP_FAILED && each >= std::max(least, kPage); each /= 2) {
    size_ = count * each;
    memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ != MAP_FAILED) break;
  }
  if (memory_ == MAP_FAILED)
    throw std::runtime_error("not enough memory to share frames with " + std::to_string(count) +
                             " slots; ask for fewer with --workers");
  for (std::size_t i = 0; i < count; ++i)
    slots_.emplace_back(static_cast<std::uint8_t*>(memory_) + i * each, each);
}

SharedSlots::~SharedSlots() { munmap(memory_, size_); }

}  // namespace kerf

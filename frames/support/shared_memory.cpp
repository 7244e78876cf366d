#include "frames/support/shared_memory.h"

#include <sys/mman.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace kerf {

SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::runtime_error("no shared memory of " + std::to_string(bytes) +
                             " bytes: " + std::generic_category().message(errno));
  data_ = static_cast<std::byte*>(memory);
}

SharedMemory::~SharedMemory() { munmap(data_, size_); }

void SharedMemory::touch() const {
  constexpr std::size_t kPage = 4096;
  for (std::size_t at = 0; at < size_; at += kPage) {
    const volatile std::byte* byte = data_ + at;
    static_cast<void>(*byte);
  }
}

}  // namespace kerf

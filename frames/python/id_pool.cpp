#include "frames/python/id_pool.h"

#include <algorithm>

namespace kerf::python {

std::vector<ObjectId> IdPool::free(std::size_t count) const {
  std::vector<ObjectId> ids;
  ids.reserve(count);
  for (std::size_t id = lowest_free_; ids.size() < count; ++id)
    if (id >= present_.size() || !present_[id]) ids.push_back({static_cast<std::uint32_t>(id)});
  return ids;
}

void IdPool::add(std::span<const ObjectId> ids) {
  for (const ObjectId id : ids) {
    if (id.index() >= present_.size()) present_.resize(id.index() + 1);
    present_[id.index()] = true;
  }
  while (lowest_free_ < present_.size() && present_[lowest_free_]) ++lowest_free_;
  size_ += ids.size();
  known_ = false;
}

void IdPool::remove(std::span<const ObjectId> ids) {
  for (const ObjectId id : ids) {
    present_[id.index()] = false;
    lowest_free_ = std::min(lowest_free_, id.index());
  }
  size_ -= ids.size();
  known_ = false;
}

std::span<const ObjectId> IdPool::all() const {
  if (!known_) {
    all_.clear();
    for (std::size_t id = 0; id < present_.size(); ++id)
      if (present_[id]) all_.push_back({static_cast<std::uint32_t>(id)});
    known_ = true;
  }
  return all_;
}

}  // namespace kerf::python

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/ids.h"

namespace kerf::python {

/// Which ids are present. New ones are the smallest that are free, so that they stay dense.
class IdPool {
 public:
  [[nodiscard]] bool has(ObjectId id) const { return id.index() < present_.size() && present_[id.index()]; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The `count` smallest free ids, ascending; they are not yet present.
  [[nodiscard]] std::vector<ObjectId> free(std::size_t count) const;
  void add(std::span<const ObjectId> ids);
  void remove(std::span<const ObjectId> ids);
  /// Those present, ascending. Valid until the next change.
  [[nodiscard]] std::span<const ObjectId> all() const;

 private:
  std::vector<bool> present_;
  std::size_t lowest_free_ = 0;
  std::size_t size_ = 0;
  mutable std::vector<ObjectId> all_;
  mutable bool known_ = true;  ///< all_ agrees with present_
};

}  // namespace kerf::python

#include "frames/python/pair_lists.h"

#include <algorithm>

#include "frames/python/arrays.h"

namespace kerf::python {

PairBuffer& PairLists::spare() {
  const auto is_free = [](const List& list) { return list.use_count() == 1; };
  const auto found = std::ranges::find_if(lists_, is_free);
  next_ = found == lists_.end() ? std::make_shared<PairBuffer>() : *found;
  if (found == lists_.end() && lists_.size() < kKept) lists_.push_back(next_);
  return *next_;
}

void PairLists::publish() { latest_ = std::move(next_); }

std::span<const Pair> PairLists::latest() const {
  return latest_ ? std::span<const Pair>(latest_->all()) : std::span<const Pair>();
}

pybind11::array PairLists::array() const {
  if (latest().empty()) return pair_array({});
  auto owner = std::make_unique<List>(latest_);
  const pybind11::capsule keeper(owner.get(), [](void* list) { delete static_cast<List*>(list); });
  (void)owner.release();
  const auto* const numbers = reinterpret_cast<const std::uint32_t*>(latest().data());
  return read_only(pybind11::array_t<std::uint32_t>(
      {static_cast<pybind11::ssize_t>(latest().size()), pybind11::ssize_t{2}}, numbers, keeper));
}

}  // namespace kerf::python

#include "frames/python/pair_lists.h"

#include <algorithm>

#include "frames/python/arrays.h"

namespace kerf::python {

namespace py = pybind11;

py::array PairLists::array(std::span<const Pair> latest) {
  if (latest.empty()) return pair_array({});
  latest_ = spare();
  auto owner = std::make_unique<std::shared_ptr<List>>(latest_);
  const py::capsule keeper(owner.get(), [](void* given) {
    const std::unique_ptr<std::shared_ptr<List>> list(static_cast<std::shared_ptr<List>*>(given));
    (*list)->has_array = false;
  });
  (void)owner.release();
  latest_->has_array = true;
  const auto* const numbers = reinterpret_cast<const std::uint32_t*>(latest.data());
  return read_only(
      py::array_t<std::uint32_t>({static_cast<py::ssize_t>(latest.size()), py::ssize_t{2}}, numbers, keeper));
}

void PairLists::let_go(const std::function<void(PairBuffer&)>& exchange) {
  if (latest_ && latest_->has_array) exchange(latest_->memory);
  latest_.reset();
}

/// A list that no array has. Its memory is that of an earlier one, if there is one to spare.
std::shared_ptr<PairLists::List> PairLists::spare() {
  constexpr std::size_t kKept = 4;
  const auto found =
      std::ranges::find_if(lists_, [](const std::shared_ptr<List>& list) { return !list->has_array; });
  if (found != lists_.end()) return *found;
  auto list = std::make_shared<List>();
  if (lists_.size() < kKept) lists_.push_back(list);
  return list;
}

}  // namespace kerf::python

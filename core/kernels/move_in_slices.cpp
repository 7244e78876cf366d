#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

#include "core/kernels/move_boxes.h"

namespace kerf {
namespace {

template <int D>
MoveRequest<D> part_of(const MoveRequest<D>& request, const Slice& slice) {
  MoveRequest<D> part = request;
  part.objects = request.objects.subspan(slice.begin, slice.end - slice.begin);
  part.boxes = request.boxes.subspan(slice.begin, slice.end - slice.begin);
  part.changed += slice.begin;
  if (part.before != nullptr) part.before += slice.begin;
  part.left_over += slice.begin;
  return part;
}

/// Appends what the slice that begins at `begin` answered to what those before it did.
template <int D>
void join(const MoveRequest<D>& request, std::size_t begin, const MoveAnswer& part, MoveAnswer& all) {
  std::copy_n(request.changed + begin, part.changed, request.changed + all.changed);
  if (request.before != nullptr)
    std::copy_n(request.before + begin, part.changed, request.before + all.changed);
  for (std::size_t k = 0; k < part.left_over; ++k)
    request.left_over[all.left_over + k] = request.left_over[begin + k] + static_cast<std::uint32_t>(begin);
  all.changed += part.changed;
  all.left_over += part.left_over;
}

/// Whether each is greater than the one before. No branch for each: so vectors compare them.
bool ascend(std::span<const ObjectId> objects) {
  unsigned falls = 0;
  for (std::size_t k = 0; k + 1 < objects.size(); ++k)
    falls |= static_cast<unsigned>(objects[k].value >= objects[k + 1].value);
  return falls == 0;
}

bool ascend(std::span<const ObjectId> objects, TaskPool& pool) {
  std::atomic<bool> all = true;
  pool.for_slices(objects.size(), [&](const Slice& slice, std::size_t) {
    const std::size_t end = std::min(slice.end + 1, objects.size());  // with the first of the next slice
    if (!ascend(objects.subspan(slice.begin, end - slice.begin))) all = false;
  });
  return all;
}

}  // namespace

template <int D>
MoveAnswer move_boxes(const MoveRequest<D>& request, TaskPool& pool) {
  const auto objects = request.objects;
  const std::size_t slices = pool.slices_of(objects.size());
  if (slices == 1 || !ascend(objects, pool)) return move_boxes(request);
  std::vector<MoveAnswer> answers(slices);
  pool.for_slices(objects.size(), [&](const Slice& slice, std::size_t k) {
    answers[k] = move_boxes(part_of(request, slice));
  });
  MoveAnswer all;
  for (std::size_t k = 0; k < slices; ++k)
    join(request, slice(objects.size(), slices, k).begin, answers[k], all);
  return all;
}

template MoveAnswer move_boxes<2>(const MoveRequest<2>&, TaskPool&);
template MoveAnswer move_boxes<3>(const MoveRequest<3>&, TaskPool&);

}  // namespace kerf

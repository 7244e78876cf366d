#include "core/recording/step_requests.h"

#include <algorithm>

namespace kerf {

template <int D>
Volume<D> volume_from(VolumeKind kind, const Box<D>& box, const Scalar* extra) {
  Volume<D> volume;
  volume.kind = kind;
  volume.box = box;
  std::copy_n(extra, extra_size<D>(kind), volume.extra.begin());
  return volume;
}

template <int D>
void StepRequests<D>::clear() {
  calls.clear();
  objects.clear();
  boxes.clear();
  extra.clear();
}

template <int D>
void StepRequests<D>::add(Call call, ObjectId object, const Box<D>& box) {
  const bool same =
      !calls.empty() && calls.back().kind == call.kind && calls.back().mobility == call.mobility;
  if (!same) calls.push_back(call);
  ++calls.back().count;
  objects.push_back(object);
  boxes.push_back(box);
}

template <int D>
void StepRequests<D>::add_insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  add({RequestKind::insert_box, mobility, 0}, object, box);
}

template <int D>
void StepRequests<D>::add_insert(ObjectId object, const Volume<D>& volume, Mobility mobility) {
  add({RequestKind::insert_volume, mobility, 0}, object, volume.box);
  extra.insert(extra.end(), volume.extra.begin(), volume.extra.begin() + extra_size<D>(volume.kind));
}

template <int D>
void StepRequests<D>::add_move(ObjectId object, const Box<D>& box) {
  add({RequestKind::move_box, Mobility::moving, 0}, object, box);
}

template <int D>
void StepRequests<D>::add_move(ObjectId object, const Volume<D>& volume) {
  add({RequestKind::move_volume, Mobility::moving, 0}, object, volume.box);
  extra.insert(extra.end(), volume.extra.begin(), volume.extra.begin() + extra_size<D>(volume.kind));
}

template <int D>
void StepRequests<D>::add_moves(std::span<const ObjectId> moved, std::span<const Box<D>> new_boxes) {
  if (moved.empty()) return;
  calls.push_back({RequestKind::move_boxes, Mobility::moving, static_cast<std::uint32_t>(moved.size())});
  objects.insert(objects.end(), moved.begin(), moved.end());
  boxes.insert(boxes.end(), new_boxes.begin(), new_boxes.end());
}

template <int D>
void StepRequests<D>::add_remove(ObjectId object) {
  add({RequestKind::remove, Mobility::moving, 0}, object, {});
}

namespace {

/// Makes the k-th of the calls for one object.
template <int D>
void call_once(const StepRequests<D>& requests, const Call& call, std::size_t k, const Scalar* extra,
               BroadPhase<D>& broad_phase) {
  const ObjectId object = requests.objects[k];
  const Box<D>& box = requests.boxes[k];
  const VolumeKind kind = broad_phase.volume_kind();
  switch (call.kind) {
    case RequestKind::insert_box:
      return (void)broad_phase.insert(object, box, call.mobility);
    case RequestKind::insert_volume:
      return (void)broad_phase.insert(object, volume_from(kind, box, extra), call.mobility);
    case RequestKind::move_box:
    case RequestKind::move_boxes:
      return (void)broad_phase.move(object, box);
    case RequestKind::move_volume:
      return (void)broad_phase.move(object, volume_from(kind, box, extra));
    case RequestKind::remove:
      return (void)broad_phase.remove(object);
  }
}

}  // namespace

template <int D>
void apply(const StepRequests<D>& requests, BroadPhase<D>& broad_phase) {
  const Scalar* extra = requests.extra.data();
  std::size_t k = 0;
  for (const Call& call : requests.calls) {
    const std::size_t end = k + call.count;
    if (call.kind == RequestKind::move_boxes) {
      (void)broad_phase.move_many(std::span(requests.objects).subspan(k, call.count),
                                  std::span(requests.boxes).subspan(k, call.count));
      k = end;
    }
    for (; k < end; ++k) {
      call_once(requests, call, k, extra, broad_phase);
      if (has_volume(call.kind)) extra += extra_size<D>(broad_phase.volume_kind());
    }
  }
}

template <int D>
void apply(const ObjectRequest<D>& request, ObjectTable<D>& objects) {
  if (request.kind == RequestKind::remove) {
    (void)objects.remove(request.object);
  } else if (is_insert(request.kind)) {
    (void)objects.insert(request.object, request.volume, request.mobility);
  } else {
    (void)objects.move(request.object, request.volume);
  }
}

template Volume<2> volume_from<2>(VolumeKind, const Box<2>&, const Scalar*);
template Volume<3> volume_from<3>(VolumeKind, const Box<3>&, const Scalar*);
template struct StepRequests<2>;
template struct StepRequests<3>;
template void apply<2>(const StepRequests<2>&, BroadPhase<2>&);
template void apply<3>(const StepRequests<3>&, BroadPhase<3>&);
template void apply<2>(const ObjectRequest<2>&, ObjectTable<2>&);
template void apply<3>(const ObjectRequest<3>&, ObjectTable<3>&);

}  // namespace kerf

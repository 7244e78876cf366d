#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"

namespace kerf {

/// The calls of BroadPhase that change objects.
enum class RequestKind : std::uint8_t {
  insert_box,
  insert_volume,
  move_box,
  move_boxes,
  move_volume,
  remove
};

/// A number of calls of one kind in a row; `move_boxes` is one call for that many objects.
struct Call {
  RequestKind kind = RequestKind::move_box;
  Mobility mobility = Mobility::moving;  ///< of insertions
  std::uint32_t count = 0;
  friend bool operator==(const Call&, const Call&) = default;
};

/// The requests to a broad phase between two steps, in their order: the order decides where entries stand,
/// and so is part of the run.
template <int D>
struct StepRequests {
  std::vector<Call> calls;
  std::vector<ObjectId> objects;  ///< one after another, as many as the calls count
  std::vector<Box<D>> boxes;      ///< as many; undefined for removed objects
  std::vector<Scalar> extra;  ///< for the calls with volumes, the numbers that the recording's kind of volume
                              ///< has beside the box

  void clear();
  void add_insert(ObjectId object, const Box<D>& box, Mobility mobility);
  void add_insert(ObjectId object, const Volume<D>& volume, Mobility mobility);
  void add_move(ObjectId object, const Box<D>& box);
  void add_move(ObjectId object, const Volume<D>& volume);
  void add_moves(std::span<const ObjectId> moved, std::span<const Box<D>> new_boxes);
  void add_remove(ObjectId object);
  friend bool operator==(const StepRequests&, const StepRequests&) = default;

 private:
  void add(Call call, ObjectId object, const Box<D>& box);
};

constexpr bool has_volume(RequestKind kind) {
  return kind == RequestKind::insert_volume || kind == RequestKind::move_volume;
}
constexpr bool is_insert(RequestKind kind) {
  return kind == RequestKind::insert_box || kind == RequestKind::insert_volume;
}

/// A volume from its box and the other numbers of its kind.
template <int D>
Volume<D> volume_from(VolumeKind kind, const Box<D>& box, const Scalar* extra);

/// The request for one object.
template <int D>
struct ObjectRequest {
  RequestKind kind = RequestKind::move_box;
  Mobility mobility = Mobility::moving;  ///< of insertions
  ObjectId object;
  Volume<D> volume;  ///< for calls with boxes the box; for a removal undefined
};

/// Calls `visit` with the request for each object, in order. `kind` is the recording's.
template <int D, class Visit>
void for_each_request(const StepRequests<D>& requests, VolumeKind kind, Visit visit) {
  const Scalar* extra = requests.extra.data();
  std::size_t k = 0;
  for (const Call& call : requests.calls) {
    for (const std::size_t end = k + call.count; k < end; ++k) {
      const bool whole = has_volume(call.kind);
      visit(ObjectRequest<D>{
          call.kind, call.mobility, requests.objects[k],
          whole ? volume_from(kind, requests.boxes[k], extra) : make_box_volume(requests.boxes[k])});
      if (whole) extra += extra_size<D>(kind);
    }
  }
}

/// Makes the same calls again.
template <int D>
void apply(const StepRequests<D>& requests, BroadPhase<D>& broad_phase);
/// Applies the requests to a table of objects.
template <int D>
void apply(const ObjectRequest<D>& request, ObjectTable<D>& objects);

}  // namespace kerf

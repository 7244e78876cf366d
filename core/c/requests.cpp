// What changes a world, for C.

#include <algorithm>
#include <utility>

#include "core/c/call.h"

namespace kerf::c {
namespace {

/// The statuses of a batch: room for them if C wants them, and what becomes of them. Where memory ends, those
/// that are not known say so.
class Statuses {
 public:
  Statuses(kerf_world& world, kerf_status* to, std::size_t count) : to_(to), from_(world.statuses) {
    if (to == nullptr) count = 0;
    try {
      from_.assign(count, kUnknown);
    } catch (const std::bad_alloc&) {
      std::fill_n(to, count, KERF_OUT_OF_MEMORY);
      throw;
    }
  }
  /// The batch is refused as a whole: they stay as they are.
  void leave() { from_.clear(); }
  ~Statuses() {
    std::ranges::transform(from_, to_, [](WorldStatus status) {
      return status == kUnknown ? kerf_status{KERF_OUT_OF_MEMORY} : to_c(status);
    });
  }
  Statuses(const Statuses&) = delete;
  Statuses& operator=(const Statuses&) = delete;
  std::span<WorldStatus> room() { return from_; }

 private:
  static constexpr auto kUnknown = static_cast<WorldStatus>(UINT8_MAX);

  kerf_status* to_;
  std::vector<WorldStatus>& from_;
};

/// Beyond the range every kind is refused.
ObjectKind to_kind(std::uint32_t kind) { return static_cast<ObjectKind>(std::min(kind, 255U)); }

/// Objects lie as far apart as the first one's size says. None: one of defaults.
kerf_status read_objects(const kerf_object* objects, std::size_t count, std::vector<ObjectDef>& defs) {
  defs.assign(std::max<std::size_t>(count, 1), {});
  if (count == 0) return KERF_OK;
  const std::uint32_t stride = objects->size;
  if (stride < kLeastObject || stride > kMostSize || stride % alignof(kerf_object) != 0) return KERF_BAD_SIZE;
  const auto* next = reinterpret_cast<const unsigned char*>(objects);
  for (ObjectDef& def : defs) {
    kerf_object object = to_object({});
    if (const kerf_status status = read_struct(next, kLeastObject, object); status != KERF_OK) return status;
    if (object.size != stride) return KERF_BAD_SIZE;
    def = {
        to_kind(object.kind), object.margin, {object.category, object.mask, object.group}, object.user_data};
    next += stride;
  }
  return KERF_OK;
}

}  // namespace
}  // namespace kerf::c

using kerf::c::change_world;
using kerf::c::guarded;
using kerf::c::is_missing;

kerf_status kerf_world_insert(kerf_world* world, const float* boxes, const kerf_object* objects,
                              size_t object_count, size_t count, kerf_handle* handles,
                              kerf_status* statuses) {
  if (handles != nullptr) std::fill_n(handles, count, kerf_handle{0});  // also if nothing can be tried
  if (is_missing(boxes, count) || is_missing(objects, object_count) || is_missing(handles, count))
    return KERF_NULL_ARGUMENT;
  if (object_count > 1 && object_count != count) return KERF_BAD_LENGTH;
  return change_world(world, [=]<int D>(kerf::World<D>& body) {
    kerf::c::Statuses to(*world, statuses, count);
    const kerf_status status = kerf::c::read_objects(objects, object_count, world->defs);
    if (status != KERF_OK) {
      to.leave();
      return status;
    }
    return kerf::c::to_c(body.insert(kerf::c::view<const kerf::Box<D>>(boxes, count), world->defs,
                                     kerf::c::view<kerf::Handle>(handles, count), to.room()));
  });
}

kerf_status kerf_world_move(kerf_world* world, const kerf_handle* handles, const float* boxes, size_t count,
                            kerf_status* statuses) {
  if (is_missing(handles, count) || is_missing(boxes, count)) return KERF_NULL_ARGUMENT;
  return change_world(world, [=]<int D>(kerf::World<D>& body) {
    kerf::c::Statuses to(*world, statuses, count);
    return kerf::c::to_c(body.move(kerf::c::view<const kerf::Handle>(handles, count),
                                   kerf::c::view<const kerf::Box<D>>(boxes, count), to.room()));
  });
}

kerf_status kerf_world_shift_origin(kerf_world* world, const float* by) {
  if (by == nullptr) return KERF_NULL_ARGUMENT;
  return change_world(world, [=]<int D>(kerf::World<D>& body) {
    kerf::Vector<D> vector;
    std::copy_n(by, D, vector.value.begin());
    return kerf::c::to_c(body.shift_origin(vector));
  });
}

kerf_status kerf_world_remove(kerf_world* world, const kerf_handle* handles, size_t count,
                              kerf_status* statuses) {
  if (is_missing(handles, count)) return KERF_NULL_ARGUMENT;
  return change_world(world, [=](auto& body) {
    kerf::c::Statuses to(*world, statuses, count);
    return kerf::c::to_c(body.remove(kerf::c::view<const kerf::Handle>(handles, count), to.room()));
  });
}

kerf_status kerf_world_set_kind(kerf_world* world, kerf_handle handle, uint32_t kind) {
  return change_world(
      world, [=](auto& body) { return kerf::c::to_c(body.set_kind({handle}, kerf::c::to_kind(kind))); });
}

kerf_status kerf_world_set_filter(kerf_world* world, kerf_handle handle, uint64_t category, uint64_t mask,
                                  int32_t group) {
  return change_world(world, [=](auto& body) {
    return kerf::c::to_c(body.set_filter({handle}, {category, mask, group}));
  });
}

kerf_status kerf_world_set_user_data(kerf_world* world, kerf_handle handle, uint64_t user_data) {
  return change_world(world,
                      [=](auto& body) { return kerf::c::to_c(body.set_user_data({handle}, user_data)); });
}

kerf_status kerf_world_set_margin(kerf_world* world, kerf_handle handle, float margin) {
  return change_world(world, [=](auto& body) { return kerf::c::to_c(body.set_margin({handle}, margin)); });
}

kerf_status kerf_world_set_callback(kerf_world* world, kerf_pair_callback callback, void* context) {
  return change_world(world, [=](auto& body) -> kerf_status {
    kerf::PairCallback function;
    if (callback != nullptr)
      function = [callback, context](const kerf::WorldPair& pair) {
        return kerf::c::call_back(
            [&] { return callback(context, reinterpret_cast<const kerf_pair*>(&pair)) != 0; });
      };
    body.set_callback(std::move(function));
    return KERF_OK;
  });
}

kerf_status kerf_world_set_threads(kerf_world* world, uint32_t threads) {
  return change_world(world, [=](auto& body) -> kerf_status {
    body.set_threads(threads);
    return KERF_OK;
  });
}

kerf_status kerf_world_step(kerf_world* world) {
  if (world == nullptr) return KERF_NULL_ARGUMENT;
  if (world->steps || world->asking > 0) return KERF_BUSY;
  world->steps = true;
  const kerf_status status = guarded([world]() -> kerf_status {
    std::visit([](auto& body) { body.step(); }, world->world);
    return KERF_OK;
  });
  world->steps = false;
  return status;
}

#include "core/world/world_status.h"

namespace kerf {

std::string_view to_string(WorldStatus status) {
  switch (status) {
    case WorldStatus::ok:
      return "done";
    case WorldStatus::clamped:
      return "done: infinite bounds of the box were replaced by the largest finite numbers";
    case WorldStatus::stale_handle:
      return "the handle names no object of this world: the object was removed, or the handle is of another "
             "world";
    case WorldStatus::bad_box:
      return "the box has NaN, or a minimum above its maximum: give it finite numbers with min <= max";
    case WorldStatus::bad_value:
      return "a kind must be one of the list, a margin finite and not negative, a shift finite";
    case WorldStatus::bad_length:
      return "the lists of a batch have different lengths: nothing was done";
    case WorldStatus::full:
      return "no index is free: remove objects, and step, which frees the indices of removed ones";
    case WorldStatus::unstepped:
      return "there are requests since the last step: step first";
    case WorldStatus::damaged:
      return "the bytes are no state that a world of this version and dimension wrote";
    case WorldStatus::busy:
      return "the pair callback of a world must not change it: wait until step() has returned";
  }
  return "no status of a world";
}

}  // namespace kerf

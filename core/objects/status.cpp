#include "core/objects/status.h"

namespace kerf {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::clamped:
      return "clamped";
    case Status::quarantined:
      return "quarantined";
    case Status::unknown_id:
      return "unknown id";
    case Status::duplicate_id:
      return "duplicate id";
    case Status::sparse_id:
      return "sparse id";
  }
  return "";
}

}  // namespace kerf

#pragma once

#include <span>

#include "core/world/object_def.h"
#include "frames/python/world.h"

namespace kerf::python {

/// What `World.objects` has of an object.
struct PythonObject {
  std::uint8_t kind;
  std::uint64_t category;
  std::uint64_t mask;
  std::int32_t group;
  float margin;
  std::uint64_t user_data;
};

PythonObject to_python(const ObjectDef& def);

/// Sets what the columns have, one row an object. Throws ValueError that names column and row.
void apply_columns(const WorldColumns& columns, std::span<ObjectDef> defs);

}  // namespace kerf::python

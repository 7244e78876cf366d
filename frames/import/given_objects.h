#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/given_id.h"
#include "core/recording/object_marks.h"
#include "core/scene/shape.h"
#include "frames/import/oddities.h"

namespace kerf {

/// A line of a table of objects: what is said of one beside its boxes, for the whole run.
template <int D>
struct GivenObject {
  GivenId object;
  std::size_t line = 0;
  ObjectMark mark;
  std::optional<Shape<D>> shape;
};

/// Reads object[,name][,color][,shape][,radius][,half_x,half_y[,half_z]][,points][,mesh] by the names of its
/// heading: a colour is "#1f77b4"; a shape is ball (radius), brick (half extents), polygon (points "x y; x y;
/// x y", convex) or, in 3D, mesh (a Wavefront OBJ file, its path from the table's folder on). Lengths are in
/// the units of the boxes. Throws UsageError that names file, line and column.
template <int D>
std::vector<GivenObject<D>> read_given_objects(const std::filesystem::path& path, Oddities& oddities);

}  // namespace kerf

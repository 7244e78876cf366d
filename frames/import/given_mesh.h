#pragma once

#include <filesystem>
#include <memory>

#include "core/scene/shape.h"

namespace kerf {

/// The triangles of a Wavefront OBJ file, larger faces divided. Throws UsageError for what is none.
std::shared_ptr<const Surface> read_mesh(const std::filesystem::path& path);

}  // namespace kerf

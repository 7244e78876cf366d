#include "frames/import/given_mesh.h"

#include <tiny_obj_loader.h>

#include <cmath>
#include <cstddef>

#include "frames/support/errors.h"

namespace kerf {

std::shared_ptr<const Surface> read_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw UsageError("there is no file " + path.string());
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromFile(path.string(), config)) throw UsageError(path.string() + ": " + reader.Error());
  auto surface = std::make_shared<Surface>();
  const std::vector<tinyobj::real_t>& numbers = reader.GetAttrib().vertices;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) {
    surface->vertices.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    if (!is_finite(surface->vertices.back()))
      throw UsageError(path.string() + " has a vertex that is nowhere");
  }
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      auto& triangle = surface->triangles.emplace_back();
      for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
        const int vertex = corners[k + corner].vertex_index;
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= surface->vertices.size())
          throw UsageError(path.string() + " has a face without a vertex");
        triangle[corner] = static_cast<std::uint32_t>(vertex);
      }
    }
  }
  if (surface->triangles.empty()) throw UsageError(path.string() + " has no face");
  return surface;
}

}  // namespace kerf

#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <limits>

namespace kerf::python {

/// In float32, and negative if it is, though it may round to zero.
constexpr float length_of(double given) { return given < 0 ? -1.0F : static_cast<float>(given); }

/// Rays, segments or swept boxes: what of their hits is wanted.
struct HitOptions {
  bool all = false;  ///< false: the first one of each
  float max_t = std::numeric_limits<float>::infinity();
};

/// Batches of queries about the boxes of a broad phase, exact for these boxes and the queries in float32.
/// Results are rows of (query, id), sorted; those with one answer a query are arrays by query. Throws
/// ValueError that names the query which cannot be answered.
class PythonQueries {
 public:
  PythonQueries() = default;
  PythonQueries(const PythonQueries&) = delete;
  PythonQueries& operator=(const PythonQueries&) = delete;
  virtual ~PythonQueries() = default;

  [[nodiscard]] virtual pybind11::array boxes(const pybind11::handle& boxes) = 0;
  [[nodiscard]] virtual pybind11::array points(const pybind11::handle& points) = 0;
  [[nodiscard]] virtual pybind11::array spheres(const pybind11::handle& centers,
                                                const pybind11::handle& radii) = 0;
  /// (n, 2, D): origin and direction.
  [[nodiscard]] virtual pybind11::tuple rays(const pybind11::handle& rays, const HitOptions& options) = 0;
  /// (n, 2, D): both ends.
  [[nodiscard]] virtual pybind11::tuple segments(const pybind11::handle& segments,
                                                 const HitOptions& options) = 0;
  [[nodiscard]] virtual pybind11::tuple sweeps(const pybind11::handle& boxes, const pybind11::handle& ways,
                                               const HitOptions& options) = 0;
  [[nodiscard]] virtual pybind11::tuple nearest(const pybind11::handle& points, std::size_t count,
                                                float max_distance) = 0;
};

}  // namespace kerf::python

#pragma once

#include <span>
#include <string>

#include "core/base/task_pool.h"
#include "core/objects/object_table.h"
#include "core/spatial/batch.h"
#include "core/spatial/spatial_index.h"
#include "frames/python/queries.h"

namespace kerf::python {

/// The queries of one dimension.
template <int D>
class QueriesOf final : public PythonQueries {
 public:
  explicit QueriesOf(unsigned threads) : pool_(threads) {}

  /// Takes the boxes as they are now.
  void update(const ObjectTable<D>& objects) { (void)index_.update(objects); }

  [[nodiscard]] pybind11::array boxes(const pybind11::handle& boxes) override;
  [[nodiscard]] pybind11::array points(const pybind11::handle& points) override;
  [[nodiscard]] pybind11::array spheres(const pybind11::handle& centers,
                                        const pybind11::handle& radii) override;
  [[nodiscard]] pybind11::tuple rays(const pybind11::handle& given, const HitOptions& options) override;
  [[nodiscard]] pybind11::tuple segments(const pybind11::handle& given, const HitOptions& options) override;
  [[nodiscard]] pybind11::tuple sweeps(const pybind11::handle& boxes, const pybind11::handle& ways,
                                       const HitOptions& options) override;
  [[nodiscard]] pybind11::tuple nearest(const pybind11::handle& points, std::size_t count,
                                        float max_distance) override;

 private:
  template <class Query>
  pybind11::array overlapping(std::span<const Query> queries, const std::string& what);
  template <class Way>
  pybind11::tuple hit(std::span<const Way> ways, bool all, const std::string& what);

  TaskPool pool_;
  SpatialIndex<D> index_;
};

}  // namespace kerf::python

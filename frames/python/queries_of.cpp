#include "frames/python/queries_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/counted.h"
#include "frames/python/arrays.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

using Floats = py::array_t<float, kInOrder>;

void check_numbers(const py::array& array, const std::string& what) {
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::value_error(what + ": the dtype is " + std::string(py::str(array.dtype())) +
                          "; give float32, float64 or whole numbers");
}

/// The shape is (n, inner...).
void check_rows(const py::array& array, const std::vector<py::ssize_t>& inner, const std::string& what) {
  bool fits = array.ndim() == static_cast<py::ssize_t>(inner.size()) + 1;
  for (std::size_t k = 0; fits && k < inner.size(); ++k)
    fits = array.shape(static_cast<py::ssize_t>(k) + 1) == inner[k];
  if (array.size() == 0 && array.ndim() == 1 && !inner.empty()) fits = true;
  if (fits) return;
  std::string shape = "(n";
  for (const py::ssize_t size : inner) shape += ", " + std::to_string(size);
  throw py::value_error(what + ": the shape is " + shape_text(array) + ", but must be " + shape +
                        (inner.empty() ? ",)" : ")"));
}

/// float32 in C order of shape (n, inner...); float64 is rounded to the nearest.
Floats float_rows(const py::handle& given, const std::vector<py::ssize_t>& inner, const std::string& what) {
  const py::array array = as_array(given, what);
  check_rows(array, inner, what);
  check_numbers(array, what);
  return Floats(array);
}

/// A radius for each of the centers: the same for all, or a row of them.
std::vector<float> radii_of(const py::handle& radii, std::size_t centers) {
  const py::array array = as_array(radii, "radii");  // once: it may be another one each time
  if (array.ndim() != 0) check_rows(array, {}, "radii");
  check_numbers(array, "radii");
  const py::array_t<double, kInOrder> given(array);
  if (array.ndim() == 0) return std::vector<float>(centers, length_of(*given.data()));
  const auto count = static_cast<std::size_t>(given.size());
  if (count != centers)
    throw py::value_error("radii: there are " + std::to_string(count) + " for " + std::to_string(centers) +
                          " centers");
  std::vector<float> lengths(count);
  std::transform(given.data(), given.data() + count, lengths.begin(), length_of);
  return lengths;
}

template <int D>
std::span<const Vector<D>> vectors_of(const Floats& floats) {
  static_assert(sizeof(Vector<D>) == D * sizeof(float));
  return {reinterpret_cast<const Vector<D>*>(floats.data()), static_cast<std::size_t>(floats.size()) / D};
}

void check_statuses(std::span<const QueryStatus> statuses, const std::string& what) {
  const auto bad =
      std::ranges::find_if(statuses, [](QueryStatus status) { return status != QueryStatus::ok; });
  if (bad != statuses.end())
    throw py::value_error(what + ": row " + std::to_string(bad - statuses.begin()) + ": " +
                          std::string(to_string(*bad)));
}

ObjectId id_of(ObjectId id) { return id; }
ObjectId id_of(const Hit& hit) { return hit.object; }

/// Rows of (query, id).
template <class Item>
py::array found_rows(const BatchResult<Item>& result) {
  py::array_t<std::uint32_t> rows({static_cast<py::ssize_t>(result.items.size()), py::ssize_t{2}});
  std::uint32_t* to = rows.mutable_data();
  for (std::uint32_t query = 0; query < result.statuses.size(); ++query) {
    for (const Item& item : result.of(query)) {
      *to++ = query;
      *to++ = id_of(item).value;
    }
  }
  return rows;
}

std::int64_t id_or_none(ObjectId id) { return id.is_none() ? -1 : std::int64_t{id.value}; }

/// By query: the id, -1 where nothing is hit, and t.
py::tuple first_of_each(const BatchResult<Hit>& result) {
  const auto count = static_cast<py::ssize_t>(result.items.size());
  py::array_t<std::int64_t> ids(count);
  py::array_t<float> at(count);
  std::ranges::transform(result.items, ids.mutable_data(),
                         [](const Hit& hit) { return id_or_none(hit.object); });
  std::ranges::transform(result.items, at.mutable_data(), [](const Hit& hit) {
    return hit.object.is_none() ? std::numeric_limits<float>::infinity() : hit.t;
  });
  return py::make_tuple(ids, at);
}

py::tuple all_of_each(const BatchResult<Hit>& result) {
  py::array_t<float> at(static_cast<py::ssize_t>(result.items.size()));
  std::ranges::transform(result.items, at.mutable_data(), &Hit::t);
  return py::make_tuple(found_rows(result), at);
}

/// What lies beyond the objects that there are is filled with -1 and infinity: much of it is a mistake, and a
/// process whose memory ends is killed.
void check_size(std::size_t points, std::size_t count, std::size_t objects) {
  constexpr std::size_t kMostBeyond = std::size_t{1} << 26U;
  if (points == 0 || count <= objects || count - objects <= kMostBeyond / points) return;
  throw py::value_error("k: " + std::to_string(count) + " for each of " + counted(points, "point") +
                        " is far beyond the " + counted(objects, "object") + " that there are; ask for " +
                        std::to_string(objects));
}

}  // namespace

template <int D>
template <class Query>
py::array QueriesOf<D>::overlapping(std::span<const Query> queries, const std::string& what) {
  BatchResult<ObjectId> result;
  {
    const py::gil_scoped_release others_run;
    overlaps<D>(index_, queries, pool_, result);
  }
  check_statuses(result.statuses, what);
  return found_rows(result);
}

template <int D>
template <class Way>
py::tuple QueriesOf<D>::hit(std::span<const Way> ways, bool all, const std::string& what) {
  BatchResult<Hit> result;
  {
    const py::gil_scoped_release others_run;
    if (all) {
      hits<D>(index_, ways, pool_, result);
    } else {
      first_hits<D>(index_, ways, pool_, result);
    }
  }
  check_statuses(result.statuses, what);
  return all ? all_of_each(result) : first_of_each(result);
}

template <int D>
py::array QueriesOf<D>::boxes(const py::handle& boxes) {
  const BoxRows<D> rows(boxes, "boxes");
  return overlapping<Box<D>>(rows.all(), "boxes");
}

template <int D>
py::array QueriesOf<D>::points(const py::handle& points) {
  const Floats floats = float_rows(points, {D}, "points");
  std::vector<Box<D>> boxes;
  for (const Vector<D>& point : vectors_of<D>(floats)) boxes.push_back({point, point});
  return overlapping<Box<D>>(boxes, "points");
}

template <int D>
py::array QueriesOf<D>::spheres(const py::handle& centers, const py::handle& radii) {
  const Floats floats = float_rows(centers, {D}, "centers");
  const auto points = vectors_of<D>(floats);
  const std::vector<float> lengths = radii_of(radii, points.size());
  std::vector<Sphere<D>> spheres(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) spheres[k] = {points[k], lengths[k]};
  return overlapping<Sphere<D>>(spheres, "centers, radii");
}

template <int D>
py::tuple QueriesOf<D>::rays(const py::handle& given, const HitOptions& options) {
  const Floats floats = float_rows(given, {2, D}, "rays");
  const auto vectors = vectors_of<D>(floats);
  std::vector<Ray<D>> rays(vectors.size() / 2);
  for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = {vectors[2 * k], vectors[2 * k + 1], options.max_t};
  return hit<Ray<D>>(rays, options.all, "rays");
}

template <int D>
py::tuple QueriesOf<D>::segments(const py::handle& given, const HitOptions& options) {
  const Floats floats = float_rows(given, {2, D}, "segments");
  const auto vectors = vectors_of<D>(floats);
  std::vector<Segment<D>> segments(vectors.size() / 2);
  for (std::size_t k = 0; k < segments.size(); ++k) segments[k] = {vectors[2 * k], vectors[2 * k + 1]};
  return hit<Segment<D>>(segments, options.all, "segments");
}

template <int D>
py::tuple QueriesOf<D>::sweeps(const py::handle& boxes, const py::handle& ways, const HitOptions& options) {
  const BoxRows<D> rows(boxes, "boxes");
  const Floats floats = float_rows(ways, {D}, "ways");
  const auto vectors = vectors_of<D>(floats);
  if (vectors.size() != rows.size())
    throw py::value_error("ways: there are " + std::to_string(vectors.size()) + " for " +
                          std::to_string(rows.size()) + " boxes");
  std::vector<SweptBox<D>> swept(rows.size());
  for (std::size_t k = 0; k < swept.size(); ++k)
    swept[k] = {rows.all()[k], vectors[k], std::min(options.max_t, 1.0F)};
  return hit<SweptBox<D>>(swept, options.all, "boxes, ways");
}

template <int D>
py::tuple QueriesOf<D>::nearest(const py::handle& points, std::size_t count, float max_distance) {
  const Floats floats = float_rows(points, {D}, "points");
  check_size(static_cast<std::size_t>(floats.size()) / D, count, index_.size());
  std::vector<Nearest<D>> queries;
  for (const Vector<D>& point : vectors_of<D>(floats)) queries.push_back({point, count, max_distance});
  BatchResult<Neighbour> result;
  {
    const py::gil_scoped_release others_run;
    kerf::nearest<D>(index_, std::span<const Nearest<D>>(queries), pool_, result);
  }
  check_statuses(result.statuses, "points");
  const py::array::ShapeContainer shape{static_cast<py::ssize_t>(queries.size()),
                                        static_cast<py::ssize_t>(count)};
  py::array_t<std::int64_t> ids(shape);
  py::array_t<double> distances(shape);
  std::fill_n(ids.mutable_data(), ids.size(), -1);
  std::fill_n(distances.mutable_data(), distances.size(), std::numeric_limits<double>::infinity());
  for (std::size_t query = 0; query < queries.size(); ++query) {
    const auto found = result.of(query);
    std::ranges::transform(found, ids.mutable_data() + query * count,
                           [](const Neighbour& near) { return id_or_none(near.object); });
    std::ranges::transform(found, distances.mutable_data() + query * count,
                           [](const Neighbour& near) { return std::sqrt(near.squared_distance); });
  }
  return py::make_tuple(ids, distances);
}

template class QueriesOf<2>;
template class QueriesOf<3>;

}  // namespace kerf::python

#include "frames/python/bind_queries.h"

#include "frames/python/queries.h"

namespace kerf::python {
namespace {

namespace py = pybind11;
using Queried = PythonBroadPhase;

constexpr float kEndless = std::numeric_limits<float>::infinity();

void bind_regions(py::class_<Queried>& type) {
  type.def(
          "query_boxes",
          [](Queried& phase, const py::object& boxes) {
            return phase.ask([&](PythonQueries& ask) { return ask.boxes(boxes); });
          },
          py::arg("boxes"),
          "Which objects overlap each box (n, 2, d): (m, 2) uint32, rows of (query, id), sorted. Touching "
          "counts.\n\n"
          "Queries see the boxes as they were given last, whether or not a step followed. Each raises "
          "ValueError for\n"
          "arrays of another shape, and, with the row, for NaN and inverted boxes.")
      .def(
          "query_points",
          [](Queried& phase, const py::object& points) {
            return phase.ask([&](PythonQueries& ask) { return ask.points(points); });
          },
          py::arg("points"),
          "Which objects hold each point (n, d): (m, 2) uint32, rows of (query, id), sorted. Errors: as "
          "query_boxes.")
      .def(
          "query_spheres",
          [](Queried& phase, const py::object& centers, const py::object& radii) {
            return phase.ask([&](PythonQueries& ask) { return ask.spheres(centers, radii); });
          },
          py::arg("centers"), py::arg("radii"),
          "Which boxes come as near as a radius to each point (n, d); radii are (n,), or one for all:\n"
          "(m, 2) uint32, rows of (query, id), sorted. Errors: as query_boxes; a negative radius is one, "
          "too.");
}

void bind_ways(py::class_<Queried>& type) {
  type.def(
          "query_rays",
          [](Queried& phase, const py::object& rays, bool all, double max_t) {
            return phase.ask([&](PythonQueries& ask) { return ask.rays(rays, {all, length_of(max_t)}); });
          },
          py::arg("rays"), py::kw_only(), py::arg("all") = false, py::arg("max_t") = kEndless,
          "What rays (n, 2, d) of an origin and a direction hit first: ids (n,) int64, -1 where nothing is "
          "hit, and\n"
          "t (n,) float32, in lengths of the direction: the hit is at origin + t * direction, at t = 0 "
          "within a box.\n\n"
          "all=True: all hits instead: (m, 2) uint32, rows of (query, id) in the order of t, and t (m,). "
          "Errors: as\n"
          "query_boxes.")
      .def(
          "query_segments",
          [](Queried& phase, const py::object& segments, bool all) {
            return phase.ask([&](PythonQueries& ask) { return ask.segments(segments, {.all = all}); });
          },
          py::arg("segments"), py::kw_only(), py::arg("all") = false,
          "As query_rays, for segments (n, 2, d) of both ends; t is from 0 to 1.")
      .def(
          "query_sweeps",
          [](Queried& phase, const py::object& boxes, const py::object& ways, bool all) {
            return phase.ask([&](PythonQueries& ask) { return ask.sweeps(boxes, ways, {.all = all}); });
          },
          py::arg("boxes"), py::arg("ways"), py::kw_only(), py::arg("all") = false,
          "As query_rays, for boxes (n, 2, d) that move without turning; t is from 0 to 1. ways are their\n"
          "displacements (n, d), in units of length.");
}

}  // namespace

void bind_queries(py::class_<Queried>& type) {
  bind_regions(type);
  bind_ways(type);
  type.def(
      "query_nearest",
      [](Queried& phase, const py::object& points, std::size_t k, double max_distance) {
        return phase.ask([&](PythonQueries& ask) { return ask.nearest(points, k, length_of(max_distance)); });
      },
      py::arg("points"), py::arg("k") = 1, py::kw_only(), py::arg("max_distance") = kEndless,
      "The k objects whose boxes are nearest to each point (n, d): ids (n, k) int64 and distances (n, k) "
      "float64,\n"
      "in units of length, 0 within a box; -1 and infinity where there are fewer. Equal distances: by id. "
      "Errors:\n"
      "as query_boxes; a k far beyond the objects that there are is one, too.");
}

}  // namespace kerf::python

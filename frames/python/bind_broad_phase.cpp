#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "frames/python/bindings.h"
#include "frames/python/broad_phase.h"
#include "frames/python/config_from.h"
#include "frames/python/errors.h"
#include "frames/python/pickling.h"
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

/// Adds the queries to `kerf.BroadPhase`.
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

namespace py = pybind11;

constexpr const char* kBroadPhaseClass = R"(Reports which of n boxes overlap, step by step: Kerf's tree.

Boxes are closed: those that touch are a pair. Pairs are exact for the boxes in float32: each overlap once, none
missed. float64 boxes and whole numbers are rounded outward to float32, so nothing is missed, and boxes that are
apart by less than float32 can tell are a pair. Infinite bounds become the largest float32.

    phase = kerf.BroadPhase(3)
    ids = phase.insert(boxes)          # (n, 2, 3): lower and upper corners
    pairs = phase.step(boxes + 0.1)    # (m, 2) uint32: ids, the smaller one first

dimension    2 or 3
tree         'kerf', the fastest parameters known, or 'kerf-paper', those of the paper
config       parameters that differ: a dict, or 'name=value,...' (`kerf render --help` lists them)
threads      how many may share a step, and do if that is faster; pairs and their order are the same for any number
changes      True: each step also finds the pairs that begin and end
record       a file: also records the run, for kerf.Recording and `kerf debug`; close() completes it, as the end of the
             object does
overwrite    the recording may take an earlier one's place

An object is used by one thread at a time; step() lets other threads of Python run meanwhile.)";

constexpr const char* kInsert = R"(Adds objects, one for each row, and returns their ids, (n,) uint32.

boxes   (n, 2, d): rows of a lower and an upper corner
ids     (n,) whole numbers that no object has; None: the smallest that are free
fixed   bool, or (n,) bool: two fixed objects are never a pair

Raises ValueError that names the row; then nothing has been added.)";

constexpr const char* kMove = R"(Gives objects new boxes; pairs follow in the next step.

boxes   (n, 2, d): rows of a lower and an upper corner
ids     (n,) whole numbers; None: a row for each object, in the order of .ids

Raises ValueError that names the row; then nothing has moved.)";

constexpr const char* kRemove = R"(Removes objects; their ids are free again.

ids   (n,) whole numbers, none of them twice

Raises ValueError that names the row; then nothing has been removed.)";

constexpr const char* kStep = R"(Brings the tree up to date and returns the pairs: (m, 2) uint32, read-only.

boxes   (n, 2, d): moves all objects first, as move(boxes) does; None: none

Each pair comes once, the smaller id first, in an order that is the same in every run.)";

std::unique_ptr<PythonBroadPhase> make(int dimension, const std::string& tree, const py::object& config,
                                       unsigned threads, bool changes,
                                       const std::optional<std::filesystem::path>& record, bool overwrite) {
  if (record) check_recording(*record, overwrite);
  return make_broad_phase(dimension, {config_from(config_of_tree(tree), config), threads, changes,
                                      record.value_or(std::filesystem::path()), overwrite});
}

std::string text_of(const PythonBroadPhase& phase) {
  return "<kerf.BroadPhase: " + std::to_string(phase.dimension()) + "D, " + std::to_string(phase.size()) +
         " objects, " + std::to_string(phase.steps()) + " steps>";
}

void bind_results(py::class_<PythonBroadPhase>& type) {
  using Subject = PythonBroadPhase;
  type.def_property_readonly("pairs", &Subject::pairs,
                             "The pairs of the last step: (m, 2) uint32, read-only.")
      .def_property_readonly("begun", &Subject::begun,
                             "Pairs of the last step that the one before did not have, in ascending order: "
                             "(m, 2) uint32. Raises RuntimeError without changes=True.")
      .def_property_readonly("ended", &Subject::ended,
                             "Pairs of the step before that the last one does not have, in ascending order: "
                             "(m, 2) uint32. Raises RuntimeError without changes=True.")
      .def_property_readonly(
          "ids", &Subject::ids,
          "The ids of all objects, ascending: (n,) uint32. Row k of boxes belongs to ids[k].")
      .def_property_readonly("boxes", &Subject::boxes,
                             "The boxes as they are taken, in the order of .ids: (n, 2, d) float32.")
      .def_property_readonly("fixed", &Subject::fixed,
                             "Which objects are fixed, in the order of .ids: (n,) bool.")
      .def_property_readonly(
          "statistics", &Subject::statistics,
          "The tree after the last step: objects, leaves, height, entries, redundancy, operators since the "
          "beginning, and the seconds of each phase of the last step.");
}

}  // namespace

void bind_broad_phase(py::module_& module) {
  using Subject = PythonBroadPhase;
  py::class_<Subject> type(module, "BroadPhase", kBroadPhaseClass);
  type.def(py::init(&make), py::arg("dimension"), py::kw_only(), py::arg("tree") = "kerf",
           py::arg("config") = py::none(), py::arg("threads") = 1, py::arg("changes") = false,
           py::arg("record") = py::none(), py::arg("overwrite") = false)
      .def("insert", &Subject::insert, py::arg("boxes"), py::kw_only(), py::arg("ids") = py::none(),
           py::arg("fixed") = false, kInsert)
      .def("move", &Subject::move, py::arg("boxes"), py::arg("ids") = py::none(), kMove)
      .def("remove", &Subject::remove, py::arg("ids"), kRemove)
      .def("step", &Subject::step, py::arg("boxes") = py::none(), kStep)
      .def("close", &Subject::close, "Completes the recording, if there is one: the file then has its name.")
      .def("__len__", &Subject::size)
      .def("__repr__", &text_of)
      .def("__reduce__", refuse_pickling("BroadPhase", "insert its boxes, .boxes and .ids, into another one"))
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", [](Subject& phase, const py::args&) { phase.close(); })
      .def_property_readonly("dimension", &Subject::dimension, "2 or 3.")
      .def_property_readonly("steps", &Subject::steps, "Steps done so far.")
      .def_property_readonly(
          "config", [](const Subject& phase) { return config_dict(phase.config()); },
          "All parameters of the tree, by name.");
  bind_results(type);
  bind_queries(type);
}

}  // namespace kerf::python

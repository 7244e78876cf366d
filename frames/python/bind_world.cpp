#include "frames/python/bindings.h"
#include "frames/python/config_from.h"
#include "frames/python/pickling.h"
#include "frames/python/world.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

constexpr const char* kWorldClass = R"(A broad phase with handles, kinds and filters, as an engine wants it.

    world = kerf.World(3)
    handles = world.insert(boxes, kind="moving", category=1, mask=3, user_data=np.arange(len(boxes)))
    world.move(handles, boxes + 0.1)
    pairs = world.step()                       # (m, 2) uint64: handles
    world.objects(pairs[:, 0])["user_data"]

A handle names one object as long as it lives, and never a later one; kerf.index_of(handles) is dense, for arrays
kept by object. A pair needs one object that is moving or a sensor. Pairs come in the order of the indices, and
depend on the requests only.

dimension   2 or 3
pairs_of    'fat': pairs of the boxes with their margins; 'exact': of the boxes as given
config      parameters of the tree that differ: a dict, or 'name=value,...'
threads     how many may share a step, and do if that is faster
tag         0 to 255, part of each handle: worlds with different tags refuse each other's handles

Boxes are taken as by kerf.BroadPhase. An object is used by one thread at a time.)";

constexpr const char* kWorldInsert =
    R"(Adds objects, one for each row, and returns their handles, (n,) uint64.

boxes       (n, 2, d): rows of a lower and an upper corner
kind        'fixed', 'kinematic', 'moving', 'sensor', or kerf.Kind
category    64 bits, and
mask        of those with which it may pair: each needs a category of the other's mask
group       not 0: objects of one group pair always (positive) or never (negative)
margin      units of length: the box may move so far before it is looked at again
user_data   64 bits of yours

All but boxes are one value for all, or (n,). Raises ValueError that names the row; then nothing has been added.)";

PairsOf pairs_of_name(const std::string& name) {
  if (name == "exact") return PairsOf::exact_boxes;
  if (name == "fat") return PairsOf::fat_boxes;
  throw py::value_error("pairs_of: '" + name + "' is neither 'fat' nor 'exact'");
}

std::unique_ptr<PythonWorld> world_from(int dimension, const std::string& pairs_of, const py::object& config,
                                        unsigned threads, int tag) {
  if (tag < 0 || tag > UINT8_MAX)
    throw py::value_error("tag: it is " + std::to_string(tag) + ", but must be from 0 to 255");
  return make_world(dimension, {.config = config_from(tuned_config(), config),
                                .pairs_of = pairs_of_name(pairs_of),
                                .threads = threads,
                                .tag = static_cast<std::uint8_t>(tag)});
}

void bind_requests(py::class_<PythonWorld>& type) {
  using Objects = const py::object&;
  type.def(
          "insert",
          [](PythonWorld& world, Objects boxes, Objects kind, Objects category, Objects mask, Objects group,
             Objects margin, Objects user_data) {
            return world.insert(boxes, {kind, category, mask, group, margin, user_data});
          },
          py::arg("boxes"), py::kw_only(), py::arg("kind") = py::none(), py::arg("category") = py::none(),
          py::arg("mask") = py::none(), py::arg("group") = py::none(), py::arg("margin") = py::none(),
          py::arg("user_data") = py::none(), kWorldInsert)
      .def("move", &PythonWorld::move, py::arg("handles"), py::arg("boxes"),
           "Gives objects new boxes; pairs follow in the next step.\n\n"
           "handles   (n,) uint64, as insert returned them\n"
           "boxes     (n, 2, d): rows of a lower and an upper corner\n\n"
           "Raises ValueError that names the row; then nothing has moved.")
      .def("shift_origin", &PythonWorld::shift_origin, py::arg("by"),
           "Moves every object by the vector (d,), as float32 rounds: for a floating origin. The tree comes\n"
           "along. Raises ValueError if the vector is not finite, or would take a box beyond the range of\n"
           "float32; then nothing has moved.")
      .def("remove", &PythonWorld::remove, py::arg("handles"),
           "Removes objects, (n,) uint64. Their pairs end in the next step; their handles name nothing from\n"
           "now on. Raises ValueError for a handle that names no object or comes twice; then nothing has "
           "been removed.")
      .def(
          "set",
          [](PythonWorld& world, Objects handles, Objects kind, Objects category, Objects mask, Objects group,
             Objects margin, Objects user_data) {
            world.set(handles, {kind, category, mask, group, margin, user_data});
          },
          py::arg("handles"), py::kw_only(), py::arg("kind") = py::none(), py::arg("category") = py::none(),
          py::arg("mask") = py::none(), py::arg("group") = py::none(), py::arg("margin") = py::none(),
          py::arg("user_data") = py::none(),
          "Changes what objects are, for handles (n,) uint64: each value is one for all, or (n,), as insert "
          "takes it;\n"
          "what is None stays. Raises ValueError that names the row; then nothing has been changed.")
      .def("step", &PythonWorld::step,
           "Brings the tree up to date and returns the pairs: (m, 2) uint64, handles.");
}

void bind_reports(py::class_<PythonWorld>& type) {
  type.def_property_readonly("pairs", &PythonWorld::pairs,
                             "The pairs of the last step: (m, 2) uint64, handles.")
      .def_property_readonly("begun", &PythonWorld::begun,
                             "Those that the step before did not have: (m, 2) uint64.")
      .def_property_readonly(
          "ended", &PythonWorld::ended,
          "Those of the step before that the last one does not have: (m, 2) uint64; handles of\n"
          "removed objects among them. Their indices are given again: read it before the next insert.")
      .def_property_readonly("of_sensor", &PythonWorld::of_sensor,
                             "Which of pairs have a sensor: (m,) bool, in their order.")
      .def_property_readonly("handles", &PythonWorld::handles, "All objects, by index: (n,) uint64.")
      .def("boxes", &PythonWorld::boxes, py::arg("handles"),
           "The boxes of handles (n,) uint64, as they are taken: (n, 2, d) float32. Raises ValueError for a "
           "handle\n"
           "that names no object.")
      .def("objects", &PythonWorld::objects, py::arg("handles"),
           "What the objects of handles (n,) uint64 are: a structured array (n,) with kind, category, mask, "
           "group,\n"
           "margin, user_data. Raises ValueError for a handle that names no object.")
      .def_property_readonly("dimension", &PythonWorld::dimension, "2 or 3.")
      .def_property_readonly("bound", &PythonWorld::bound,
                             "More than each handle's index: the length of arrays kept by index.")
      .def("save", &PythonWorld::save,
           "Everything but the threads, as bytes. Raises RuntimeError unless a step followed the last "
           "request.")
      .def("restore", &PythonWorld::restore, py::arg("state"),
           "Becomes the world that was saved, with its pairs, begun, ended and tag, and goes on exactly as\n"
           "that one. Raises ValueError for other bytes.")
      .def("__len__", &PythonWorld::size);
}

}  // namespace

void bind_world(py::module_& module) {
  register_world_rows();
  py::class_<PythonWorld> type(module, "World", kWorldClass);
  type.def(py::init(&world_from), py::arg("dimension"), py::kw_only(), py::arg("pairs_of") = "fat",
           py::arg("config") = py::none(), py::arg("threads") = 1, py::arg("tag") = 0)
      .def("__repr__",
           [](const PythonWorld& world) {
             return "<kerf.World: " + std::to_string(world.dimension()) + "D, " +
                    std::to_string(world.size()) + " objects>";
           })
      .def("__reduce__", refuse_pickling("World", "save() gives its state as bytes, which restore() takes"));
  bind_requests(type);
  bind_reports(type);
}

}  // namespace kerf::python

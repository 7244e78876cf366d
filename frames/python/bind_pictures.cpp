#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <string>
#include <vector>

#include "core/objects/object_table.h"
#include "frames/python/arrays.h"
#include "frames/python/bindings.h"
#include "frames/python/broad_phase.h"
#include "frames/python/judged_boxes.h"
#include "frames/python/picture.h"
#include "frames/python/recording.h"
#include "frames/python/scenes.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

std::vector<Pair> pairs_of_rows(const py::handle& given, std::size_t rows) {
  std::vector<Pair> pairs;
  if (given.is_none()) return pairs;
  for (const RowPair& pair : reported_pairs(py::reinterpret_borrow<py::object>(given), kGiven)) {
    for (const std::int64_t row : pair)
      if (row < 0 || static_cast<std::uint64_t>(row) >= rows)
        throw py::value_error("pairs: there is no row " + std::to_string(row) + " of " +
                              std::to_string(rows));
    if (pair[0] == pair[1]) throw py::value_error("pairs: row " + std::to_string(pair[0]) + " with itself");
    pairs.push_back(make_pair({static_cast<std::uint32_t>(pair[0])}, {static_cast<std::uint32_t>(pair[1])}));
  }
  return pairs;
}

template <int D>
py::array picture_of(const py::array& boxes, const py::handle& given, const PictureOptions& options) {
  const BoxRows<D> rows(boxes, "source");
  const std::vector<Pair> pairs = pairs_of_rows(given, rows.size());
  ObjectTable<D> objects;
  for (std::uint32_t row = 0; row < rows.size(); ++row)
    (void)objects.insert({row}, rows.all()[row], Mobility::moving);
  const std::vector<Body<D>> bodies = recorded_bodies(objects);
  FrameInput<D> input;
  input.bodies = bodies;
  input.pairs = pairs;
  input.caption.scene = "boxes of an array";
  input.caption.is_run = false;
  input.caption.objects = objects.size();
  input.caption.pairs = pairs.size();
  input.caption.knows_pairs = !given.is_none();
  input.caption.knows_contacts = false;
  return draw(input, options);
}

/// Boxes (n, 2, d), and lines for pairs (m, 2) of their rows or None: (height, width, 3) uint8. Throws
/// ValueError for pairs of rows that do not exist.
py::array box_picture(const py::handle& boxes, const py::handle& pairs, const PictureOptions& options) {
  const py::array array = as_array(boxes, "source");
  const bool is_2d = array.ndim() == 3 && array.shape(2) == 2;
  return is_2d ? picture_of<2>(array, pairs, options) : picture_of<3>(array, pairs, options);
}

namespace py = pybind11;

constexpr const char* kRender =
    R"(Draws a moment: an RGB picture, (height, width, 3) uint8, the same in every run.

source   a kerf.Recording, a kerf.BroadPhase, boxes (n, 2, d), or the name of a scene (kerf.scenes())
step     of a recording or a scene; None: the last step of a recording, step 100 of a scene
event    of a recording: the moment right after it
pairs    of boxes: (m, 2) rows, drawn as lines
layers   as for `kerf render --show`: 'objects,pairs', or changes such as '-legend,+leaves'
camera   as for `kerf render --camera`: 'yaw=30,pitch=38' (3D), 'center=0:5,width=40' (2D)

Draws without a display. Needs OSMesa or EGL (Debian: libosmesa6, or libegl1 and libegl-mesa0).)";

py::array render_recording(PythonRecording& recording, const std::optional<std::uint32_t>& step,
                           const std::optional<std::uint64_t>& event, const PictureOptions& options) {
  if (event) return recording.picture(recording.position_of(*event), options);
  return recording.picture(Position::end_of(step.value_or(recording.steps())), options);
}

py::array render(const py::object& source, const std::optional<std::uint32_t>& step,
                 const std::optional<std::uint64_t>& event, const py::object& pairs, int width, int height,
                 const std::string& layers, const std::string& camera) {
  constexpr std::uint32_t kStepOfScene = 100;
  const PictureOptions options{width, height, layers, camera};
  const bool is_recording = py::isinstance<PythonRecording>(source);
  if (event && !is_recording) throw py::value_error("event: only a recording has events");
  if (is_recording) return render_recording(source.cast<PythonRecording&>(), step, event, options);
  if (py::isinstance<py::str>(source))
    return scene_picture({source.cast<std::string>(), step.value_or(kStepOfScene), {}}, options);
  if (step) throw py::value_error("step: only a recording or a scene has steps to choose from");
  if (py::isinstance<PythonBroadPhase>(source))
    return source.cast<const PythonBroadPhase&>().picture(options);
  return box_picture(source, pairs, options);
}

SceneRun scene_run(const std::string& scene, std::uint32_t steps, std::uint32_t objects, std::uint32_t grow,
                   std::uint64_t seed) {
  return {scene, steps, {.objects = objects, .steps = grow, .seed = seed}};
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("render", &render, py::arg("source"), py::arg("step") = py::none(), py::kw_only(),
             py::arg("event") = py::none(), py::arg("pairs") = py::none(), py::arg("width") = 1280,
             py::arg("height") = 720, py::arg("layers") = "", py::arg("camera") = "", kRender);
  module.def("scenes", &scene_list, "The scenes of `kerf scenes`: a list of (name, dimension, summary).");
  module.def(
      "scene_boxes",
      [](const std::string& scene, std::uint32_t steps, std::uint32_t objects, std::uint32_t grow,
         std::uint64_t seed) { return scene_boxes(scene_run(scene, steps, objects, grow, seed)); },
      py::arg("scene"), py::kw_only(), py::arg("steps") = 100, py::arg("objects") = 0, py::arg("grow") = 0,
      py::arg("seed") = 1,
      "The boxes of a scene in each of its steps: a list of (n, 2, d) float32; rows are added as objects "
      "come.\n\n"
      "objects   moving ones at the end; 0: the scene's own number\n"
      "grow      steps until all are there; 0: the scene's own number");
  module.def(
      "record",
      [](const std::string& scene, const std::filesystem::path& out, std::uint32_t steps,
         std::uint32_t objects, std::uint32_t grow, std::uint64_t seed, const std::string& tree,
         bool overwrite) {
        record_scene(scene_run(scene, steps, objects, grow, seed), tree, out, overwrite);
        return open_recording(out);
      },
      py::arg("scene"), py::arg("out"), py::kw_only(), py::arg("steps") = 100, py::arg("objects") = 0,
      py::arg("grow") = 0, py::arg("seed") = 1, py::arg("tree") = "kerf-paper", py::arg("overwrite") = false,
      "Runs a scene with the tree and records it into the file `out`: a kerf.Recording.\n\n"
      "objects   moving ones at the end; 0: the scene's own number\n"
      "grow      steps until all are there; 0: the scene's own number\n"
      "tree      'kerf-paper' or 'kerf'");
}

}  // namespace kerf::python

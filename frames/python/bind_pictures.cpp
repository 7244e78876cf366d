#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "frames/python/arrays.h"
#include "frames/python/bindings.h"
#include "frames/python/box_picture.h"
#include "frames/python/broad_phase.h"
#include "frames/python/recording.h"
#include "frames/python/scenes.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

constexpr const char* kRender =
    R"(Draws a moment: an RGB picture, (height, width, 3) uint8, the same in every run.

source   a kerf.Recording, a kerf.BroadPhase, boxes (n, 2, d), or the name of a scene (kerf.scenes())
step     of a recording or a scene; None: the last step of a recording, step 100 of a scene
event    of a recording: the moment right after it
pairs    of boxes: (m, 2) rows, drawn as lines
layers   as for `kerf render --show`: 'objects,pairs', or changes such as '-legend,+leaves'
camera   as for `kerf render --camera`: 'yaw=30,pitch=38' (3D), 'center=0:5,width=40' (2D)

Draws without a display. Needs OSMesa or EGL (Debian: libosmesa6 or libegl-mesa0).)";

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

#include "frames/python/scenes.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "core/bsp/bsp.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/python/arrays.h"
#include "frames/python/config_from.h"
#include "frames/python/errors.h"
#include "frames/python/interrupts.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/record_run.h"
#include "frames/support/errors.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// The scene of the run, whose options it can have.
CatalogScene scene_of(const SceneRun& run) {
  try {
    CatalogScene scene = find_scene(run.name);
    if (run.options.steps != 0) check_grows(scene, "grow");
    return scene;
  } catch (const UsageError& error) {
    throw py::value_error(error.what());
  }
}

/// Runs a scene to its end, or until Python is interrupted.
template <int D>
void advance_all(Scene<D>& scene, std::uint32_t steps, Interrupts& interrupts,
                 const std::function<void()>& after_step) {
  while (scene.step() < steps && !interrupts.requested()) {
    scene.advance();
    after_step();
  }
}

template <int D>
void record(const SceneEntry<D>& entry, const std::string& scene, const SceneRun& run, const Config& config,
            PartRecording& part, Interrupts& interrupts) {
  RecordingInfo info = info_of_run(scene, D, run.options, config, entry.needs.volume);
  record_run<D>({entry, run.options, std::move(info), run.steps}, part.path(),
                [&](std::uint32_t /*step*/) { return !interrupts.requested(); });
}

template <int D>
std::vector<std::vector<Box<D>>> boxes_of(const SceneEntry<D>& entry, const SceneRun& run,
                                          Interrupts& interrupts) {
  std::vector<std::vector<Box<D>>> all;
  Bsp<D> tree(tuned_config(), entry.needs.volume);
  const auto scene = entry.make(tree, run.options);
  advance_all<D>(*scene, run.steps, interrupts, [&] {
    std::vector<Box<D>>& boxes = all.emplace_back();
    std::ranges::transform(scene->bodies(), std::back_inserter(boxes), &Body<D>::box);
  });
  return all;
}

template <int D>
py::list list_boxes(const SceneEntry<D>& entry, const SceneRun& run) {
  Interrupts interrupts;
  const auto all = [&] {
    const py::gil_scoped_release others_run;
    return boxes_of(entry, run, interrupts);
  }();
  interrupts.rethrow();
  py::list arrays;
  for (const std::vector<Box<D>>& boxes : all) arrays.append(box_array<D>(boxes));
  return arrays;
}

template <int D>
py::array picture_of(const SceneEntry<D>& entry, const SceneRun& run, const PictureOptions& options) {
  Interrupts interrupts;
  Bsp<D> tree(default_config(entry.needs), entry.needs.volume);
  const auto scene = entry.make(tree, run.options);
  {
    const py::gil_scoped_release others_run;
    advance_all<D>(*scene, run.steps, interrupts, [] {});
  }
  interrupts.rethrow();
  FrameInput<D> input;
  input.bodies = scene->bodies();
  input.tree = &tree.tree();
  input.pairs = scene->pairs();
  input.contacts = scene->contacts();
  input.caption.scene = run.name;
  input.caption.broad_phase = kPaperTree;
  input.caption.step = scene->step();
  input.caption.objects = tree.objects().size();
  input.caption.moving =
      static_cast<std::uint32_t>(std::ranges::count(scene->bodies(), Mobility::moving, &Body<D>::mobility));
  input.caption.pairs = scene->pairs().size();
  input.caption.contacts = scene->contacts().size();
  input.caption.statistics = tree.statistics();
  return draw(input, options);
}

}  // namespace

py::list scene_list() {
  py::list all;
  for (const CatalogScene& scene : scene_catalog())
    all.append(std::visit(
        [&](const auto* entry) {
          return py::make_tuple(scene.name, scene.dimension(), std::string(entry->summary));
        },
        scene.entry));
  return all;
}

void record_scene(const SceneRun& run, const std::string& tree, const std::filesystem::path& out,
                  bool overwrite) {
  const CatalogScene scene = scene_of(run);
  (void)config_of_tree(tree);
  Interrupts interrupts;
  {
    const py::gil_scoped_release others_run;
    of_recording([&] {
      check_recording(out, overwrite);
      PartRecording part(out, replace_if(overwrite));
      part.write([&] {
        std::visit(
            [&](const auto* entry) {
              const Config config = tree == kTunedTree ? tuned_config() : default_config(entry->needs);
              record(*entry, scene.name, run, config, part, interrupts);
            },
            scene.entry);
        if (!interrupts.requested()) part.keep();
      });
    });
  }
  interrupts.rethrow();
}

py::list scene_boxes(const SceneRun& run) {
  return std::visit([&](const auto* entry) { return list_boxes(*entry, run); }, scene_of(run).entry);
}

py::array scene_picture(const SceneRun& run, const PictureOptions& options) {
  return std::visit([&](const auto* entry) { return picture_of(*entry, run, options); }, scene_of(run).entry);
}

}  // namespace kerf::python

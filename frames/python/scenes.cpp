#include "frames/python/scenes.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/python/arrays.h"
#include "frames/python/config_from.h"
#include "frames/python/errors.h"
#include "frames/python/interrupts.h"
#include "frames/sequence/part_recording.h"
#include "frames/support/errors.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

CatalogScene scene_called(const std::string& name) {
  try {
    return find_scene(name);
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
RecordingInfo info_of(const SceneRun& run, const Config& config, VolumeKind volume) {
  RecordingInfo info;
  info.dimension = D;
  info.volume = volume;
  info.config = config;
  info.scene = run.name;
  info.seed = run.options.seed;
  info.objects = run.options.objects;
  info.grow = run.options.steps;
  info.recycle = run.options.recycle;
  return info;
}

template <int D>
void record(const SceneEntry<D>& entry, const SceneRun& run, const Config& config, PartRecording& part,
            Interrupts& interrupts) {
  Bsp<D, EventLog> tree(config, entry.needs.volume);
  Recorder<D> recorder(tree, part.path(), info_of<D>(run, config, entry.needs.volume));
  const auto scene = entry.make(recorder, run.options);
  advance_all<D>(*scene, run.steps, interrupts, [&] { (void)tree.trace().take(); });
  recorder.finish();
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
  const CatalogScene scene = scene_called(run.name);
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
              record(*entry, run, config, part, interrupts);
            },
            scene.entry);
        if (!interrupts.requested()) part.keep();
      });
    });
  }
  interrupts.rethrow();
}

py::list scene_boxes(const SceneRun& run) {
  return std::visit([&](const auto* entry) { return list_boxes(*entry, run); }, scene_called(run.name).entry);
}

py::array scene_picture(const SceneRun& run, const PictureOptions& options) {
  return std::visit([&](const auto* entry) { return picture_of(*entry, run, options); },
                    scene_called(run.name).entry);
}

}  // namespace kerf::python

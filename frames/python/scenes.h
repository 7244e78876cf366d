#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/scene/scene.h"
#include "frames/python/picture.h"

namespace kerf::python {

/// A scene of the catalogue, and how long it runs.
struct SceneRun {
  std::string name;
  std::uint32_t steps = 0;
  SceneOptions options;
};

/// Name, dimension and summary of each scene: a list of tuples.
pybind11::list scene_list();

/// Runs a scene with the tree and records it. Throws ValueError for a name that is none and for growth of a
/// scene that does not grow, RecordingError if the file cannot be written; an earlier file is replaced only
/// if `overwrite`.
void record_scene(const SceneRun& run, const std::string& tree, const std::filesystem::path& out,
                  bool overwrite);

/// The boxes of a scene in each of its steps: a list of (n, 2, d) float32, with more rows as bodies come.
pybind11::list scene_boxes(const SceneRun& run);

/// A scene after its steps, with bodies as they are: (height, width, 3) uint8.
pybind11::array scene_picture(const SceneRun& run, const PictureOptions& options);

}  // namespace kerf::python

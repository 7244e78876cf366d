#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "frames/bench/bench_scene.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/page/cell.h"
#include "frames/sequence/render_request.h"

namespace kerf {

/// What is measured of a broad phase.
struct Measures {
  bool times = true;
  bool counts = true;
  bool errors = false;  ///< pairs against the oracle's
};

/// A broad phase that is given the boxes of a motion or of a scene.
struct RunCell {
  /// A motion, or a scene.
  std::variant<const BenchScene*, CatalogScene> scene;
  int dimension = 3;
  SceneOptions options;     ///< objects, of a motion with the fixed ones; seed; of a scene, when it has grown
  std::string broad_phase;  ///< as `kerf bench --algorithms` takes it
  std::uint32_t warm_up = 0;
  std::uint32_t steps = 0;
  Measures measures;
};

/// A shard of the frames of a recording.
struct FramesCell {
  RenderTexts texts;  ///< without the output
};

/// One cell of a study. It depends on nothing but its settings.
struct StudyCell {
  std::string
      id;         ///< the name of its file and folder; two cells share it if and only if their settings agree
  Json settings;  ///< all that its figures depend on
  double patience = 0;  ///< seconds after which it is given up
  std::variant<RunCell, FramesCell> work;

  [[nodiscard]] bool is_frames() const { return work.index() == 1; }
};

/// A text file that names many measurements (docs/STUDIES.md).
struct Study {
  std::string file;  ///< as the user named it
  std::string name;
  std::vector<StudyCell> cells;
};

/// Throws UsageError, which names the file and the key, for whatever is wrong with it: also for scenes, broad
/// phases and recordings that do not exist.
Study read_study(const std::string& file);

/// The id of a cell: words to read, and a hash of all settings.
std::string cell_id(const std::string& words, const Json& settings);

}  // namespace kerf

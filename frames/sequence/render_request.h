#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/recording_info.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/sequence/film_files.h"
#include "frames/support/picture_size.h"
#include "frames/support/shard.h"
#include "frames/support/step_range.h"
#include "viz/draw/layers.h"
#include "viz/gl/backend.h"

namespace kerf {

/// The options of `kerf render` as the user typed them; empty: not given.
struct RenderTexts {
  std::string scene;
  std::string steps;
  std::string size;
  std::string objects;
  std::string grow;
  std::string recycle;
  std::string broad_phase;
  std::string volume;
  std::string show;
  std::string view;
  std::string camera;
  std::string config;
  std::string out;
  std::string video;
  std::string fps;
  std::string contact_sheet;
  std::string seed;
  std::string record;
  std::string workers;
  std::string shard;
  bool ids = false;
  std::string backend;
  std::string camera_path;
  std::string samples;
  std::string beside;
  bool timed = false;
  bool overwrite = false;
  bool resume = false;
};

/// Drawn at twice the size, with one sample a pixel, and averaged.
inline constexpr int kSupersampled = 2;

/// A recording that is rendered.
struct RecordingSource {
  std::filesystem::path path;
  RecordingInfo info;
  std::uint32_t steps = 0;
  std::uint64_t last_state_hash = 0;
  std::uint64_t identity = 0;  ///< of what it holds, boxes and another engine's pairs included
};

/// What to render, every part of it checked.
struct RenderRequest {
  std::string name;    ///< of the scene, or of a recording's frames
  CatalogScene scene;  ///< if there is no recording
  std::optional<RecordingSource> recording;
  StepRange steps;
  PictureSize size;
  SceneOptions options;
  LayerSet layers = LayerSet::all();
  std::string camera;
  std::filesystem::path camera_file;  ///< empty: none
  std::string camera_path;            ///< the file's text; empty: the camera stands still
  int samples = 0;                    ///< of each pixel, see kSupersampled; 0: a choice
  GlBackend backend = GlBackend::any;
  BroadPhaseChoice broad_phase;
  /// Broad phases in panes beside that one, each with its structure; none: a picture without panes.
  std::optional<std::vector<BroadPhaseChoice>> beside;
  bool timed = false;  ///< panes show what a step takes: two runs then differ
  std::filesystem::path out;
  FilmRequest film;
  std::filesystem::path record;  ///< empty: none
  int workers = 1;               ///< drawing processes; 0: this one
  Shard shard;                   ///< of the frames
  bool ids = false;              ///< also write what is in each picture, by name
  bool overwrite = false;
  bool resume = false;  ///< keep frames that exist already

  [[nodiscard]] int dimension() const { return recording ? recording->info.dimension : scene.dimension(); }
};

inline constexpr std::uint32_t kMaxRequestedObjects = 1'000'000;

inline constexpr int kMaxWorkers = 256;

/// Throws UsageError that says what to do. Reads the file of the camera path and touches no other.
RenderRequest parse_request(const RenderTexts& texts);

/// The steps of a scene that is recorded: how many, since a recording has every one. Throws UsageError if the
/// text is not empty and no such number.
void check_recorded_steps(const std::string& text);

/// Whether the text names a recording: not a scene, but a file. Throws std::runtime_error if the file does
/// not exist.
bool names_recording(const RenderTexts& texts);
/// Throws UsageError if a recording is given with an option that the recording fixes.
void refuse_of_recording(const RenderTexts& texts, const char* option, const std::string& text);
/// The same for all options of a running scene except its steps, since part of a recording can be drawn.
void refuse_scene_options(const RenderTexts& texts);
/// The same for a recording, which is opened for its info. Throws std::runtime_error if it cannot be read.
RenderRequest parse_recording_request(const RenderTexts& texts);

}  // namespace kerf

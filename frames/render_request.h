#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "frames/broad_phase_choice.h"
#include "frames/picture_size.h"
#include "frames/scene_catalog.h"
#include "frames/step_range.h"
#include "viz/draw/layers.h"

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
  std::string camera;
  std::string config;
  std::string out;
  std::string video;
  std::string fps;
  std::string contact_sheet;
  std::string seed;
  std::string record;
  bool overwrite = false;
};

/// What is to be rendered, every part of it checked.
struct RenderRequest {
  CatalogScene scene;
  StepRange steps;
  PictureSize size;
  SceneOptions options;
  LayerSet layers = LayerSet::all();
  std::string camera;
  BroadPhaseChoice broad_phase;
  std::filesystem::path out;
  std::filesystem::path video;  ///< empty: none
  int fps = 25;
  std::filesystem::path contact_sheet;  ///< empty: none
  std::filesystem::path record;         ///< empty: none
  bool overwrite = false;
};

inline constexpr std::uint32_t kMaxRequestedObjects = 1'000'000;

/// Throws UsageError that says what to do. Touches no file.
RenderRequest parse_request(const RenderTexts& texts);

}  // namespace kerf

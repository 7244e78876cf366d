#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/trace/event.h"
#include "frames/picture_size.h"
#include "frames/step_range.h"

namespace kerf {

inline constexpr const char* kManifestName = "frames.json";

/// One picture of a sequence and the state of the simulation that it shows.
struct FrameRecord {
  std::string file;            ///< name inside the sequence's folder
  std::uint32_t step = 0;      ///< steps done
  std::uint32_t objects = 0;   ///< fixed ones included
  std::uint64_t pairs = 0;     ///< candidates of that step
  std::uint64_t contacts = 0;  ///< of them those that touch
  std::uint32_t height = 0;
  std::uint32_t leaves = 0;
  std::uint64_t entries = 0;
  std::array<std::uint64_t, kOperatorCount> operators{};  ///< acted since the beginning, by kind
  std::uint64_t events = 0;                               ///< since the frame before
  std::uint64_t state_hash = 0;                           ///< of the tree
  std::uint64_t pixel_hash = 0;                           ///< of the decoded pixels
};

/// What a sequence of frames is: everything needed to make it again, and what each frame shows.
struct Manifest {
  std::string scene;
  int dimension = 3;
  std::string needs;
  std::uint64_t seed = 1;
  std::uint32_t requested_objects = 0;  ///< 0: the scene's own number
  std::uint32_t grow = 0;               ///< steps of growth; 0: the scene's own number
  StepRange steps;
  PictureSize size;
  std::string layers;
  std::string camera;
  std::string broad_phase;
  std::optional<Config> config;  ///< of the tree; none: another broad phase
  std::string volume;
  std::uint32_t recycle = 0;  ///< steps between two objects that fall anew; 0: none does
  bool complete = false;      ///< every frame of `steps` was made
  std::vector<FrameRecord> frames;
};

/// The manifest as JSON text; hashes are 16 hexadecimal digits.
std::string to_json(const Manifest& manifest);

/// Writes `folder`/frames.json atomically. Throws std::system_error with path and reason.
void save(const Manifest& manifest, const std::filesystem::path& folder);

/// "buckets_000042.png"
std::string frame_file_name(const std::string& scene, std::uint32_t frame);

}  // namespace kerf

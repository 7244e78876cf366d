#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/trace/event.h"
#include "frames/sequence/render_request.h"
#include "frames/support/picture_size.h"
#include "frames/support/step_range.h"

namespace kerf {

inline constexpr const char* kManifestName = "frames.json";

/// One picture of a sequence and the state of the simulation that it shows.
struct FrameRecord {
  std::uint32_t index = 0;     ///< in the whole sequence, from 0
  std::string file;            ///< name inside the sequence's folder
  std::uint32_t step = 0;      ///< steps done
  std::string given_step;      ///< what another engine calls this step; empty: it has no other name
  std::uint32_t objects = 0;   ///< fixed ones included
  std::uint64_t pairs = 0;     ///< candidates of that step
  std::uint64_t contacts = 0;  ///< those of them that touch
  std::uint32_t height = 0;
  std::uint32_t leaves = 0;
  std::uint64_t entries = 0;
  std::array<std::uint64_t, kOperatorCount> operators{};  ///< acted since the beginning, by kind
  std::uint64_t events = 0;                               ///< since the frame before
  std::uint64_t state_hash = 0;                           ///< of the tree
  std::uint64_t pixel_hash = 0;                           ///< of the decoded pixels
};

/// A sequence of frames, and what each frame shows.
struct Manifest {
  std::string
      header;        ///< JSON object: all that is needed to make the sequence again. Equal: the same sequence
  std::string name;  ///< the beginning of the files' names
  StepRange steps;
  PictureSize size;
  Shard shard;            ///< the frames made here
  bool complete = false;  ///< all of its frames are made
  std::vector<FrameRecord> frames;

  /// How many frames a complete one has.
  [[nodiscard]] std::uint32_t wanted_frames() const;
};

/// The manifest of a request before its first frame.
Manifest begin_manifest(const RenderRequest& request);

/// The manifest as JSON text; hashes are 16 hexadecimal digits.
std::string to_json(const Manifest& manifest);

/// Writes `folder`/frames.json atomically. Throws std::system_error with path and reason.
void save(const Manifest& manifest, const std::filesystem::path& folder);

/// Throws std::runtime_error with the path if there is none, or none that `save` wrote.
Manifest read_manifest(const std::filesystem::path& folder);

/// The first difference between two headers: "camera: '' and 'yaw=10'".
std::string first_difference(const std::string& header, const std::string& other);

/// "buckets_000042.png"
std::string frame_file_name(const std::string& name, std::uint32_t frame);

}  // namespace kerf

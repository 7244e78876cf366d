#pragma once

#include <cstdint>
#include <memory>

#include "frames/manifest.h"
#include "frames/render_request.h"
#include "viz/image/image.h"

namespace kerf {

/// A running simulation and a camera on it.
class Film {
 public:
  Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  virtual ~Film() = default;

  /// One step of the simulation.
  virtual void advance() = 0;
  /// The picture of the present step; valid until the next call.
  virtual const Image& draw() = 0;
  /// What the present step's picture shows. `file` and `pixel_hash` are left to the caller. Events are
  /// counted from the call before.
  virtual FrameRecord record() = 0;
  /// Ends the recording, if one was asked for. Nothing may be asked of the film afterwards.
  virtual void finish() = 0;
};

/// Throws UsageError for a configuration that cannot work, std::runtime_error if nothing can be drawn.
std::unique_ptr<Film> make_film(const RenderRequest& request);

}  // namespace kerf

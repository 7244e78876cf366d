#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "frames/sequence/manifest.h"
#include "viz/image/image.h"

namespace kerf {

/// A picture to make. Its maker fills in `record.pixel_hash`.
struct FrameOrder {
  FrameRecord record;
  std::vector<std::uint8_t> parcel;   ///< the content of the frame, see `pack`
  std::optional<std::uint64_t> kept;  ///< an earlier run's file should have these pixels
  bool wants_image = false;           ///< the receiver needs the pixels, too
};

/// Makes pictures one after another, in the process and the thread that created it.
class FrameMaker {
 public:
  FrameMaker() = default;
  FrameMaker(const FrameMaker&) = delete;
  FrameMaker& operator=(const FrameMaker&) = delete;
  virtual ~FrameMaker() = default;

  struct Made {
    std::uint64_t pixel_hash = 0;
    const Image* image = nullptr;  ///< valid until the next call
  };
  /// Draws the parcel and writes `file`, unless it is there already with the pixels of `kept`.
  virtual Made make(const std::string& file, std::span<const std::uint8_t> parcel,
                    std::optional<std::uint64_t> kept) = 0;
};

/// Called in each process that draws, before its first picture: GL starts there.
using StartFrameMaker = std::function<std::unique_ptr<FrameMaker>()>;

/// Makes the pictures of a sequence and delivers them in the order in which they were added. After an error,
/// finished ones still come, with gaps. The next call throws the error.
class FrameCrew {
 public:
  /// `image` has no pixels unless they were requested.
  using Deliver = std::function<void(const FrameRecord& record, const Image& image)>;

  FrameCrew() = default;
  FrameCrew(const FrameCrew&) = delete;
  FrameCrew& operator=(const FrameCrew&) = delete;
  virtual ~FrameCrew() = default;

  /// Waits while as many pictures as memory allows are in flight.
  virtual void add(FrameOrder order) = 0;
  /// Waits until every picture is delivered.
  virtual void finish() = 0;
};

}  // namespace kerf

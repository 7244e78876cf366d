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

/// A picture to be made. `record.pixel_hash` is found out by who makes it.
struct FrameOrder {
  FrameRecord record;
  std::vector<std::uint8_t> parcel;   ///< what is drawn, see `pack`
  std::optional<std::uint64_t> kept;  ///< an earlier run's file should have these pixels
  bool wants_image = false;           ///< who waits for the picture needs its pixels, too
};

/// Makes pictures one after another, in the process and the thread in which it was made.
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
  /// Draws what the parcel says and writes `file`, unless it is there already with the pixels of `kept`.
  virtual Made make(const std::string& file, std::span<const std::uint8_t> parcel,
                    std::optional<std::uint64_t> kept) = 0;
};

/// Called in each process that draws, before its first picture: GL starts there.
using StartFrameMaker = std::function<std::unique_ptr<FrameMaker>()>;

/// Who makes the pictures of a sequence. They are delivered in the order in which they were added; after an
/// error those that were finished nevertheless come last, with gaps. The error comes out of the next call.
class FrameCrew {
 public:
  /// `image` has no pixels unless they were wanted.
  using Deliver = std::function<void(const FrameRecord& record, const Image& image)>;

  FrameCrew() = default;
  FrameCrew(const FrameCrew&) = delete;
  FrameCrew& operator=(const FrameCrew&) = delete;
  virtual ~FrameCrew() = default;

  /// Waits while as many pictures as memory may hold are on their way.
  virtual void add(FrameOrder order) = 0;
  /// Waits until every picture is delivered.
  virtual void finish() = 0;
};

}  // namespace kerf

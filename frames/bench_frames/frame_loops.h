#pragma once

#include <cstdint>
#include <filesystem>

#include "frames/support/picture_size.h"

namespace kerf {

/// What to draw, how often, and where the files go.
struct FrameLoop {
  PictureSize size;
  std::uint32_t boxes = 0;
  std::uint32_t frames = 0;
  int workers = 1;
  std::filesystem::path folder;
};

/// The obvious loop: simulate, draw, read, encode by stb, in one thread but for the rasteriser's.
void run_naive_loop(const FrameLoop& loop);
/// As `kerf render` does it.
void run_pipeline(const FrameLoop& loop);
/// Processor seconds for encoding and writing one drawn frame.
double measure_encoding(const FrameLoop& loop);

}  // namespace kerf

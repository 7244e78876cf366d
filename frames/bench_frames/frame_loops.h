#pragma once

#include <cstdint>
#include <filesystem>

#include "frames/support/picture_size.h"

namespace kerf {

/// What is drawn, how often, and where the files go.
struct FrameLoop {
  PictureSize size;
  std::uint32_t boxes = 0;
  std::uint32_t frames = 0;
  int workers = 1;
  std::filesystem::path folder;
};

/// The loop that one writes first: simulate, draw, read, encode by stb, in one thread but for the
/// rasteriser's.
void run_naive_loop(const FrameLoop& loop);
/// As `kerf render` does it.
void run_pipeline(const FrameLoop& loop);
/// Processor seconds that one frame takes to be encoded and written, once it is drawn.
double measure_encoding(const FrameLoop& loop);

}  // namespace kerf

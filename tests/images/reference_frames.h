#pragma once

#include <filesystem>
#include <string>

#include "frames/sequence/draw_list_file.h"
#include "viz/draw/frame_renderer.h"

namespace kerf::test {

/// Where the approved pictures are, and where tests put those that they draw: of the build, unless the
/// environment's KERF_NEW_FRAMES names another folder.
std::filesystem::path reference_folder();
std::filesystem::path new_folder();

/// What has changed in a picture against its reference, the commands that show and approve it included;
/// empty: nothing. The picture and its ids are written to `new_folder()` in any case.
std::string compare_with_reference(const std::string& name, const Image& image, const StoredIds& ids);

/// The same for what a renderer drew last.
template <int D>
std::string compare_with_reference(const std::string& name, const FrameRenderer<D>& renderer,
                                   const Image& image) {
  return compare_with_reference(name, image, {renderer.ids(), renderer.rasterizer()});
}

}  // namespace kerf::test

#include "frames/sequence/farm/picture_maker.h"

#include <stdexcept>

#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/farm/frame_parcel.h"
#include "frames/sequence/farm/panes_parcel.h"
#include "frames/support/errors.h"
#include "viz/draw/panes_renderer.h"
#include "viz/image/contact_sheet.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

FrameOptions frame_options(const RenderRequest& request) {
  const int scale = request.samples == kSupersampled ? 2 : 1;
  FrameOptions options;
  options.width = scale * request.size.width;
  options.height = scale * request.size.height;
  options.layers = request.layers;
  options.camera = request.camera;
  options.ids = request.ids;
  options.camera_path = request.camera_path;
  options.backend = request.backend;
  return options;
}

/// Draws parcels of single frames.
template <int D>
class FrameDrawer {
 public:
  explicit FrameDrawer(const FrameOptions& options) : renderer_(options) {}
  const Image& draw(std::span<const std::uint8_t> parcel) {
    const FrameParcel<D> frame = unpack<D>(parcel);
    return renderer_.render(frame.input(), frame.plan);
  }
  [[nodiscard]] StoredIds ids() const { return {renderer_.ids(), renderer_.rasterizer()}; }

 private:
  FrameRenderer<D> renderer_;
};

/// Draws parcels of panes.
template <int D>
class PanesDrawer {
 public:
  explicit PanesDrawer(const FrameOptions& options) : renderer_(options) {}
  const Image& draw(std::span<const std::uint8_t> parcel) {
    return renderer_.render(unpack_panes<D>(parcel));
  }
  [[nodiscard]] StoredIds ids() const { return {renderer_.ids(), renderer_.rasterizer()}; }

 private:
  PanesRenderer<D> renderer_;
};

template <class Drawer>
class PictureMaker final : public FrameMaker {
 public:
  explicit PictureMaker(const RenderRequest& request)
      : folder_(request.out), size_(request.size), wants_ids_(request.ids), drawer_(frame_options(request)) {}

  Made make(const std::string& file, std::span<const std::uint8_t> parcel,
            std::optional<std::uint64_t> kept) override {
    const std::filesystem::path path = folder_ / file;
    if (kept && is_kept(path, *kept)) return {*kept, &kept_};
    const Image& image = in_size(drawer_.draw(parcel));
    write_png(path, image, Replace::earlier, Sync::later);  // SequenceFolder syncs them all
    if (wants_ids_) write_ids(path, drawer_.ids());
    return {pixel_hash(image), &image};
  }

 private:
  /// A file that is missing or damaged is made again.
  bool is_kept(const std::filesystem::path& path, std::uint64_t hash) {
    try {
      if (wants_ids_ && !read_ids(path)) return false;
      kept_ = read_png(path);
      return pixel_hash(kept_) == hash;
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  const Image& in_size(const Image& drawn) {
    if (drawn.width == size_.width) return drawn;
    return shrunk_ = downscale(drawn, size_.width, size_.height);
  }

  std::filesystem::path folder_;
  PictureSize size_;
  bool wants_ids_;
  Drawer drawer_;
  Image kept_;
  Image shrunk_;
};

}  // namespace

std::unique_ptr<FrameMaker> make_picture_maker(const RenderRequest& request) {
  try {
    if (request.beside && request.dimension() == 2)
      return std::make_unique<PictureMaker<PanesDrawer<2>>>(request);
    if (request.beside) return std::make_unique<PictureMaker<PanesDrawer<3>>>(request);
    if (request.dimension() == 2) return std::make_unique<PictureMaker<FrameDrawer<2>>>(request);
    return std::make_unique<PictureMaker<FrameDrawer<3>>>(request);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace kerf

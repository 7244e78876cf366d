#include "frames/farm/picture_maker.h"

#include <stdexcept>

#include "frames/diff/draw_list_file.h"
#include "frames/errors.h"
#include "frames/farm/frame_parcel.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

template <int D>
class PictureMaker final : public FrameMaker {
 public:
  explicit PictureMaker(const RenderRequest& request)
      : folder_(request.out),
        wants_ids_(request.ids),
        renderer_({request.size.width, request.size.height, request.layers, request.camera, 0, request.ids}) {
  }

  Made make(const std::string& file, std::span<const std::uint8_t> parcel,
            std::optional<std::uint64_t> kept) override {
    const std::filesystem::path path = folder_ / file;
    if (kept && is_kept(path, *kept)) return {*kept, &kept_};
    const FrameParcel<D> frame = unpack<D>(parcel);
    const Image& image = renderer_.render(frame.input(), frame.plan);
    write_png(path, image);
    if (wants_ids_) write_ids(path, {renderer_.ids(), renderer_.rasterizer()});
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

  std::filesystem::path folder_;
  bool wants_ids_;
  FrameRenderer<D> renderer_;
  Image kept_;
};

}  // namespace

std::unique_ptr<FrameMaker> make_picture_maker(const RenderRequest& request) {
  try {
    if (request.dimension() == 2) return std::make_unique<PictureMaker<2>>(request);
    return std::make_unique<PictureMaker<3>>(request);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace kerf

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "viz/image/png.h"
#include "viz/image/png_chunks.h"
#include "viz/image/png_format.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;  // a device may be endless

bool starts_like_png(Bytes bytes) {
  return bytes.size() >= png::kSignature.size() &&
         std::equal(png::kSignature.begin(), png::kSignature.end(), bytes.begin());
}

/// Reads no further than the first block if it is not a PNG.
std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path) {
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail_to_read_png(path, "it is a folder");
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) fail_to_read_png(path, std::generic_category().message(errno));
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> block(1U << 16U);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
    if (!starts_like_png(bytes)) fail_to_read_png(path, "it is not a PNG");
    if (bytes.size() > kMaxBytes) break;
  }
  if (std::ferror(file.get()) != 0) fail_to_read_png(path, std::generic_category().message(errno));
  return bytes;
}

/// libpng at work on bytes in memory. It leaves its functions by longjmp when it finds a fault, so the two
/// below that call it own nothing: all that lives longer is here.
class Decoder {
 public:
  explicit Decoder(Bytes bytes)
      : bytes_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_fault, on_warning)),
        info_(png_create_info_struct(png_)) {
    if (info_ == nullptr) throw std::bad_alloc();
  }
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// False if the file is damaged, see `fault`.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way
    png_set_read_fn(png_, this, give_bytes);
    png_set_user_limits(png_, kMaxImageSide, kMaxImageSide);
    png_set_benign_errors(png_, 0);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr,
                                -1);  // `walk_png_chunks` has seen them
    png_read_info(png_, info_);
    ask_for_rgba();
    png_read_update_info(png_, info_);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return fault_.empty();
  }

  [[nodiscard]] int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
  [[nodiscard]] int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }
  [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] bool is_deep() const { return png_get_bit_depth(png_, info_) == 16; }
  [[nodiscard]] bool has_palette() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE; }
  /// The colours of pixels that are numbers of the palette; nothing if it has no such number.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> colors_of(
      const std::vector<std::uint8_t>& numbers) const {
    png_colorp colors = nullptr;
    int count = 0;
    png_bytep opacities = nullptr;
    int opacity_count = 0;
    png_get_PLTE(png_, info_, &colors, &count);
    png_get_tRNS(png_, info_, &opacities, &opacity_count, nullptr);
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * numbers.size());
    for (const std::uint8_t number : numbers) {
      if (number >= count) return std::nullopt;
      const png_color& color = colors[number];
      const std::uint8_t opacity = number < opacity_count ? opacities[number] : 0xff;
      rgba.insert(rgba.end(), {color.red, color.green, color.blue, opacity});
    }
    return rgba;
  }
  /// What libpng said first.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  /// A palette stays one, a byte a pixel: libpng takes for black what is beyond its end.
  void ask_for_rgba() {
    png_set_interlace_handling(png_);
    if (has_palette()) return png_set_packing(png_);
    const bool is_deep = png_get_bit_depth(png_, info_) == 16;
    png_set_expand(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, is_deep ? 0xffffU : 0xffU, PNG_FILLER_AFTER);
  }
  static Decoder& self(png_structp png) { return *static_cast<Decoder*>(png_get_error_ptr(png)); }
  static void give_bytes(png_structp png, png_bytep out, std::size_t count) {
    Bytes& bytes = static_cast<Decoder*>(png_get_io_ptr(png))->bytes_;
    if (count > bytes.size()) png_error(png, "the file ends too early");
    std::memcpy(out, bytes.data(), count);
    bytes = bytes.subspan(count);
  }
  /// What libpng would only warn of, more pixels than there is room for, would not be looked at.
  static void on_warning(png_structp png, png_const_charp what) {
    if (self(png).fault_.empty()) self(png).fault_ = what;
  }
  [[noreturn]] static void on_fault(png_structp png, png_const_charp what) {
    on_warning(png, what);
    png_longjmp(png, 1);
  }

  Bytes bytes_;
  std::string fault_;
  png_structp png_;
  png_infop info_;
};

std::vector<png_bytep> rows_of(std::vector<std::uint8_t>& pixels, std::size_t row_bytes) {
  std::vector<png_bytep> rows;
  for (std::size_t at = 0; at < pixels.size(); at += row_bytes) rows.push_back(pixels.data() + at);
  return rows;
}

/// Channels of 16 bits, the upper byte first, into two of 8.
void part_halves(const std::vector<std::uint8_t>& pixels, StoredPicture& picture) {
  picture.image.rgba.resize(pixels.size() / 2);
  picture.lower.resize(pixels.size() / 2);
  for (std::size_t i = 0; i < picture.lower.size(); ++i) {
    picture.image.rgba[i] = pixels[2 * i];
    picture.lower[i] = pixels[2 * i + 1];
  }
}

}  // namespace

StoredPicture read_stored_picture(const std::filesystem::path& path) {
  return read_stored_picture(read_whole_file(path), path);
}

StoredPicture read_stored_picture(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  if (bytes.empty()) fail_to_read_png(path, "the file is empty");
  if (bytes.size() > kMaxBytes) fail_to_read_png(path, "the file is too long for a PNG");
  if (!starts_like_png(bytes)) fail_to_read_png(path, "it is not a PNG");
  StoredPicture picture;
  picture.chunks = walk_png_chunks(bytes, path);
  Decoder decoder(bytes);
  const auto damaged = [&] { fail_to_read_png(path, "it is damaged (" + decoder.fault() + ")"); };
  if (!decoder.read_header()) damaged();
  picture.image.width = decoder.width();
  picture.image.height = decoder.height();
  std::vector<std::uint8_t> pixels(decoder.row_bytes() * static_cast<std::size_t>(decoder.height()));
  if (!decoder.read_rows(rows_of(pixels, decoder.row_bytes()).data())) damaged();
  if (decoder.has_palette()) {
    auto colors = decoder.colors_of(pixels);
    if (!colors) fail_to_read_png(path, "it is damaged (a pixel has a colour that is not in its palette)");
    picture.image.rgba = std::move(*colors);
  } else if (decoder.is_deep()) {
    part_halves(pixels, picture);
  } else {
    picture.image.rgba = std::move(pixels);
  }
  return picture;
}

Image read_png(const std::filesystem::path& path) { return read_png(read_whole_file(path), path); }

Image read_png(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  StoredPicture picture = read_stored_picture(bytes, path);
  if (!picture.lower.empty()) fail_to_read_png(path, "its channels have 16 bits; give it 8");
  if (!picture.chunks.empty())
    fail_to_read_png(path, "its chunk " + picture.chunks.front().type +
                               " makes more of it than its pixels say; save it without");
  return std::move(picture.image);
}

}  // namespace kerf

#include "viz/image/stored_picture.h"

#include <gmock/gmock.h>

#include <span>
#include <stdexcept>

#include "tests/support/png_file.h"
#include "tests/viz/message_of.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using testing::HasSubstr;

constexpr std::uint8_t kGrey = 0;
constexpr std::uint8_t kRgb = 2;
constexpr std::uint8_t kPalette = 3;
constexpr std::uint8_t kRgba = 6;

const std::string kColor = "\x80\x12\x34";

std::span<const std::uint8_t> span_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

StoredPicture read(const PngFile& file) { return read_stored_picture(span_of(file.bytes()), "a.png"); }

std::string refusal(const PngFile& file) {
  return test::message_of<std::runtime_error>([&] { read_png(span_of(file.bytes()), "a.png"); });
}

/// Of one colour, each kind as its type says.
PngFile of(std::uint8_t type, std::uint8_t depth, const std::string& row) {
  PngFile file;
  file.color_type = type;
  file.depth = depth;
  file.rows = png_rows(row);
  return file;
}

PngFile plain() { return of(kRgb, 8, repeat(kColor, 16)); }

/// Seven passes, of which each has its own rows.
PngFile interlaced() {
  PngFile file = plain();
  file.interlace = 1;
  file.rows.clear();
  constexpr int kPasses[][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const auto& [x0, y0, dx, dy] : kPasses)
    file.rows += png_rows(repeat(kColor, (16 - x0 + dx - 1) / dx),
                          static_cast<std::uint32_t>((16 - y0 + dy - 1) / dy));
  return file;
}

TEST(StoredPicture, PalettesInterlacingAndDepthsAreThePixelsThatTheyStandFor) {
  const Image expected = make_image(16, 16, 0x801234ffU);
  PngFile palette = of(kPalette, 8, std::string(16, '\1'));
  palette.before = {{"PLTE", "xyz" + kColor}};
  PngFile bits = of(kPalette, 1, "\xff\xff");
  bits.before = palette.before;
  for (const PngFile& file :
       {plain(), palette, bits, interlaced(), of(kRgba, 8, repeat(kColor + "\xff", 16))})
    EXPECT_EQ(read(file).image, expected) << int{file.color_type} << " of " << int{file.depth} << " bits";
  EXPECT_EQ(read(of(kGrey, 1, "\xff\xff")).image, make_image(16, 16, 0xffffffffU));
  EXPECT_EQ(read(of(kGrey, 4, repeat("\x33", 8))).image, make_image(16, 16, 0x333333ffU));
}

/// Programs show it as they like, so that two such pictures cannot be called the same. A later libpng
/// refuses it before we do.
TEST(StoredPicture, WhatAPaletteDoesNotHaveIsRefused) {
  const auto names_it =
      ::testing::AnyOf(HasSubstr("a colour that is not in its palette"), HasSubstr("palette index"));
  PngFile palette = of(kPalette, 8, std::string(15, '\1') + '\2');
  palette.before = {{"PLTE", kColor + kColor}};
  EXPECT_THAT(refusal(palette), names_it);
  PngFile bits = of(kPalette, 4, std::string(7, '\x11') + '\x12');
  bits.before = palette.before;
  EXPECT_THAT(refusal(bits), names_it);
}

TEST(StoredPicture, APaletteHasOpacities) {
  PngFile palette = of(kPalette, 8, std::string(16, '\0'));
  palette.before = {{"PLTE", kColor + kColor}, {"tRNS", "\x07"}};
  EXPECT_EQ(read(palette).image, make_image(16, 16, 0x80123407U));
}

TEST(StoredPicture, TransparencyByAChunkIsSeen) {
  PngFile file = plain();
  file.before = {{"tRNS", std::string("\0\x80\0\x12\0\x34", 6)}};
  EXPECT_EQ(read(file).image, make_image(16, 16, 0x80123400U));
}

TEST(StoredPicture, BothHalvesOf16BitsAreKept) {
  const StoredPicture deep = read(of(kRgb, 16, repeat("\x80\x81\x12\x13\x34\x35", 16)));
  EXPECT_EQ(deep.image, make_image(16, 16, 0x801234ffU));
  EXPECT_EQ(deep.lower, make_image(16, 16, 0x811335ffU).rgba);
  EXPECT_EQ(count_different_lower(deep, deep), 0U);
  EXPECT_EQ(count_different_lower(deep, read(plain())), 256U);
  // 8 bits are 16 of which both halves are the same.
  EXPECT_EQ(count_different_lower(read(of(kRgb, 16, repeat("\x80\x80\x12\x12\x34\x34", 16))), read(plain())),
            0U);
  EXPECT_THAT(refusal(of(kRgb, 16, repeat("\x80\x81\x12\x13\x34\x35", 16))), HasSubstr("16 bits"));
}

TEST(StoredPicture, ChunksThatMakeMoreOfThePixelsAreKeptAndRemarksAreNot) {
  for (const char* type :
       {"gAMA", "cHRM", "sRGB", "iCCP", "sBIT", "bKGD", "eXIf", "pHYs", "cICP", "acTL", "zzZz"}) {
    PngFile file = plain();
    file.before = {{type, "some"}};
    EXPECT_EQ(different_chunks(read(file), read(plain())), type);
    EXPECT_EQ(different_chunks(read(plain()), read(file)), type);
    EXPECT_EQ(different_chunks(read(file), read(file)), "");
    PngFile other = file;
    other.before = {{type, "same"}};
    EXPECT_EQ(different_chunks(read(file), read(other)), type);
    EXPECT_THAT(refusal(file), HasSubstr(type));
    PngFile later = plain();
    later.after = file.before;
    EXPECT_EQ(different_chunks(read(file), read(later)), type) << "behind the pixels some programs heed none";
    EXPECT_EQ(different_chunks(read(later), read(later)), "");
  }
  for (const char* type : {"tEXt", "zTXt", "iTXt", "tIME"}) {
    PngFile file = plain();
    file.after = {{type, "remark"}};
    EXPECT_EQ(different_chunks(read(file), read(plain())), "") << type;
    EXPECT_EQ(refusal(file), "") << type;
  }
}

TEST(StoredPicture, WhatWouldNotBeLookedAtIsRefused) {
  EXPECT_THAT(test::message_of<std::runtime_error>(
                  [] { read_stored_picture(span_of(plain().bytes() + plain().bytes()), "a.png"); }),
              HasSubstr("bytes follow the end"));
  PngFile more = plain();
  more.rows += "more";
  EXPECT_THAT(refusal(more), HasSubstr("damaged"));
  PngFile less = plain();
  less.rows.pop_back();
  EXPECT_THAT(refusal(less), HasSubstr("damaged"));
}

}  // namespace
}  // namespace kerf::test

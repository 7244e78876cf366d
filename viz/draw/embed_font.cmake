# Writes the bytes of INPUT as `kerf::font_file()` (viz/draw/font.h) to OUTPUT.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(................................................................................)" "\\1\n"
  bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"viz/draw/font.h\"

namespace kerf {
namespace {
constexpr std::uint8_t kBytes[] = {
${bytes}};
}  // namespace

std::span<const std::uint8_t> font_file() { return kBytes; }

}  // namespace kerf
")

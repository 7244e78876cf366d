#include <stdexcept>
#include <vector>

#include "tests/fuzz/parsers/parser_cases.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

std::uint32_t checksum(CaseBytes bytes) {
  std::uint32_t sum = ~0U;
  for (const std::uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

/// Puts the checksum of every whole chunk right.
std::vector<std::uint8_t> with_checksums(CaseBytes given) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kFrame = 12;
  std::vector<std::uint8_t> bytes(given.begin(), given.end());
  for (std::size_t at = kSignature; at + kFrame <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = (length << 8U) | bytes[at + i];
    if (length > bytes.size() - at - kFrame) break;
    const std::uint32_t sum = checksum(CaseBytes(bytes).subspan(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      bytes[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += kFrame + length;
  }
  return bytes;
}

std::string read(CaseBytes bytes) {
  try {
    const Image image = read_png(bytes, "case.png");
    const bool sane =
        image.width > 0 && image.height > 0 && image.width <= kMaxImageSide && image.height <= kMaxImageSide;
    const bool whole = image.rgba.size() == image.stride() * static_cast<std::size_t>(image.height);
    return sane && whole ? "" : "accepted, but no picture";
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).find("case.png") == std::string::npos
               ? "an error that does not name the file"
               : "";
  }
}

}  // namespace

std::string png_case(CaseBytes bytes) {
  const std::string finding = read(bytes);
  return finding.empty() ? read(with_checksums(bytes)) : finding;
}

}  // namespace kerf::test

#include "tests/support/png_file.h"

namespace kerf::test {
namespace {

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t sum = ~0U;
  for (const char byte : bytes) {
    sum ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

std::uint32_t adler32(const std::string& bytes) {
  constexpr std::uint32_t kPrime = 65521;
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<std::uint8_t>(byte)) % kPrime;
    b = (b + a) % kPrime;
  }
  return (b << 16U) | a;
}

std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

/// A zlib stream of one block that is stored, not compressed.
std::string stored(const std::string& bytes) {
  const auto size = static_cast<std::uint16_t>(bytes.size());
  const auto low_first = [](std::uint16_t x) {
    return std::string{static_cast<char>(x), static_cast<char>(x >> 8U)};
  };
  return "\x78\x01\x01" + low_first(size) + low_first(static_cast<std::uint16_t>(~size)) + bytes +
         big_endian(adler32(bytes));
}

}  // namespace

std::string big_endian(std::uint32_t number, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(number >> (8 * static_cast<unsigned>(i)));
  return text;
}

std::string repeat(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string png_rows(const std::string& row, std::uint32_t height) {
  return repeat(std::string(1, '\0') + row, static_cast<int>(height));
}

std::string PngFile::bytes() const {
  const std::string header = big_endian(width) + big_endian(height) +
                             std::string{static_cast<char>(depth), static_cast<char>(color_type), 0, 0,
                                         static_cast<char>(interlace)};
  std::string file = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header);
  for (const auto& [type, data] : before) file += chunk(type, data);
  file += chunk("IDAT", stored(rows));
  for (const auto& [type, data] : after) file += chunk(type, data);
  return file + chunk("IEND", "");
}

}  // namespace kerf::test

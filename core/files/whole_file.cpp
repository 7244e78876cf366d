#include "core/files/whole_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace kerf {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error("cannot read " + file.string() + ": " + reason);
}

}  // namespace

std::optional<std::string> read_whole_file_if_there(const std::filesystem::path& file, std::size_t most) {
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "rb"), close);
  if (!stream && (errno == ENOENT || errno == ENOTDIR)) return std::nullopt;
  if (!stream) refuse(file, std::strerror(errno));
  std::string bytes;
  std::array<char, std::size_t{1} << 16U> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), stream.get())) {
    bytes.append(buffer.data(), size);
    if (bytes.size() > most) refuse(file, "it has more than " + std::to_string(most) + " bytes");
  }
  if (std::ferror(stream.get()) != 0) refuse(file, std::strerror(errno));
  return bytes;
}

std::string read_whole_file(const std::filesystem::path& file, std::size_t most) {
  auto bytes = read_whole_file_if_there(file, most);
  if (!bytes) refuse(file, std::strerror(ENOENT));
  return *std::move(bytes);
}

}  // namespace kerf

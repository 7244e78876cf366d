#include "frames/support/atomic_file.h"

#include <stdexcept>
#include <string>
#include <system_error>

#include "core/files/whole_file.h"

namespace kerf {

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                           Replace replace) {
  PartFile part(path, replace);
  part.write(bytes);
  part.keep();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text, Replace replace) {
  write_file_atomically(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, replace);
}

void copy_file_atomically(const std::filesystem::path& from, const std::filesystem::path& to) {
  write_file_atomically(to, read_whole_file(from));
}

void make_writable_folder(const std::filesystem::path& folder, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw std::runtime_error("cannot make the folder " + folder.string() + ": " + error.message() +
                             "; choose another with " + option);
  }
  try {
    const PartFile trial(folder / "trial");
  } catch (const std::system_error& reason) {
    throw std::runtime_error("cannot write into the folder " + folder.string() + ": " +
                             reason.code().message() + "; choose another with " + option);
  }
}

std::string with_disk_advice(std::string message) {
  const std::string advice = "; free some space or choose another place";
  const bool full = message.find(std::generic_category().message(ENOSPC)) != std::string::npos;
  if (full && message.find(advice) == std::string::npos) message += advice;
  return message;
}

}  // namespace kerf

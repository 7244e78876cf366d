#include "frames/support/atomic_file.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

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
  std::ifstream file(from, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("cannot read " + from.string());
  write_file_atomically(to, bytes);
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

}  // namespace kerf

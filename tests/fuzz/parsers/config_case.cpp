#include <stdexcept>
#include <string_view>

#include "core/base/config.h"
#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {

std::string config_case(CaseBytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string before = to_string(Config{});
  Config config;
  try {
    kerf::apply(config, text);
  } catch (const std::invalid_argument& error) {
    if (std::string_view(error.what()).empty()) return "an error without a message";
    return to_string(config) == before ? "" : "a refused text changed the configuration";
  }
  try {
    check(config);
    const std::string written = to_string(config);
    Config read;
    kerf::apply(read, written);
    return to_string(read) == written ? "" : "read back as another: " + written;
  } catch (const std::invalid_argument& error) {
    return std::string("accepted, but not valid: ") + error.what();
  }
}

}  // namespace kerf::test

#include <stdexcept>

#include "tests/fuzz/parsers/parser_cases.h"
#include "viz/draw/camera_path.h"

namespace kerf::test {
namespace {

template <int D>
std::string try_path(std::string_view text) {
  try {
    const CameraPath<D> path(text);
    for (const double step : {0.0, 1.0, 17.5, 4e9}) (void)path.at(step, CameraChoice<D>{});
    return "";
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).find("line") == std::string::npos
               ? "an error that does not name the line: " + std::string(error.what())
               : "";
  }
}

}  // namespace

std::string camera_path_case(CaseBytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string finding = try_path<2>(text);
  return finding.empty() ? try_path<3>(text) : finding;
}

}  // namespace kerf::test

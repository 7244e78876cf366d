#include <array>
#include <sstream>

#include "frames/sequence/render_request.h"
#include "frames/support/errors.h"
#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

constexpr std::array kOptions{&RenderTexts::scene,   &RenderTexts::steps,  &RenderTexts::size,
                              &RenderTexts::objects, &RenderTexts::grow,   &RenderTexts::show,
                              &RenderTexts::camera,  &RenderTexts::config, &RenderTexts::out,
                              &RenderTexts::video,   &RenderTexts::fps,    &RenderTexts::contact_sheet,
                              &RenderTexts::seed,    &RenderTexts::volume, &RenderTexts::recycle};

/// What a request must be for the rest of the program to believe it.
std::string check_request(const RenderRequest& request) {
  const StepRange& steps = request.steps;
  if (steps.first == 0 || steps.first > steps.last || steps.stride == 0 || steps.last > kMaxStep)
    return "steps";
  if (steps.frames() > kMaxFrames || steps.step_of(steps.frames() - 1) > steps.last) return "frames";
  if (request.size.width <= 0 || request.size.height <= 0) return "size";
  if (request.options.objects > kMaxRequestedObjects) return "objects";
  if (request.film.fps < 1 || request.film.fps > 240) return "fps";
  if (!(LayerSet::parse(to_string(request.layers)) == request.layers)) return "layers";
  check(request.broad_phase.config);
  return "";
}

}  // namespace

std::string request_case(CaseBytes bytes) {
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  RenderTexts texts;
  for (const auto option : kOptions) std::getline(lines, texts.*option);
  try {
    const std::string wrong = check_request(parse_request(texts));
    return wrong.empty() ? "" : "accepted, but not valid: " + wrong;
  } catch (const UsageError& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

}  // namespace kerf::test

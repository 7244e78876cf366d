#include <utility>

#include "core/recording/recording_info.h"
#include "frames/study/matrix.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

/// The options of `kerf render` that a matrix of frames takes, by key.
constexpr std::pair<const char*, std::string RenderTexts::*> kPictureKeys[] = {
    {"steps", &RenderTexts::steps},
    {"size", &RenderTexts::size},
    {"show", &RenderTexts::show},
    {"camera", &RenderTexts::camera},
    {"samples", &RenderTexts::samples}};

RenderTexts read_pictures(JsonObject& matrix, const std::filesystem::path& folder) {
  RenderTexts texts;
  const std::filesystem::path recording = matrix.word("recording", "");
  texts.scene = recording.is_absolute() ? recording : folder / recording;
  for (const auto& [key, text] : kPictureKeys) texts.*text = matrix.word(key, "");
  texts.workers = "0";
  return texts;
}

/// The errors of `kerf render` name its options.
RenderRequest checked_request(const JsonObject& matrix, const RenderTexts& texts) {
  try {
    return parse_recording_request(texts);
  } catch (const std::runtime_error& error) {
    matrix.refuse("recording", error.what());
  }
}

std::string text_of(const StepRange& steps) {
  return std::to_string(steps.first) + ":" + std::to_string(steps.last) + ":" + std::to_string(steps.stride);
}

}  // namespace

std::vector<StudyCell> read_frames(JsonObject& matrix, const std::filesystem::path& folder) {
  RenderTexts texts = read_pictures(matrix, folder);
  const RenderRequest request = checked_request(matrix, texts);
  const std::uint32_t frames = request.steps.frames();
  const std::uint64_t parts = matrix.number("parts", 1, frames, (frames + 9) / 10);
  std::vector<StudyCell> cells;
  for (std::uint64_t part = 1; part <= parts; ++part) {
    texts.shard = std::to_string(part) + "/" + std::to_string(parts);
    StudyCell cell;
    cell.settings = {{"kind", "frames"},
                     {"scene", request.name},
                     {"dimension", request.dimension()},
                     {"run", to_hex(request.recording->identity)},
                     {"range", text_of(request.steps)},
                     {"part", texts.shard},
                     {"size", std::to_string(request.size.width) + "x" + std::to_string(request.size.height)},
                     {"show", texts.show},
                     {"camera", texts.camera},
                     {"samples", texts.samples}};
    cell.id = cell_id(request.name + ".frames." + texts.shard, cell.settings);
    cell.work = FramesCell{texts};
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace kerf

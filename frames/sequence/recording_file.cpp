#include "frames/sequence/recording_file.h"

#include <algorithm>

#include "frames/sequence/record_run.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::size_t changed_parameters(const Config& config, const Config& other) {
  return static_cast<std::size_t>(std::ranges::count_if(config_fields(), [&](const ConfigField& field) {
    return get(config, field.name) != get(other, field.name);
  }));
}

}  // namespace

RecordingInfo recording_info(const RenderRequest& request) {
  if (!request.broad_phase.is_tree())
    throw UsageError(
        "'" + request.broad_phase.name +
        "' cannot be recorded: only a tree has events and a state; choose --broad-phase kerf or kerf-paper");
  return info_of_run(request.scene.name, request.scene.dimension(), request.options,
                     request.broad_phase.config, request.broad_phase.volume);
}

std::string_view tree_of(const RecordingInfo& info) {
  const bool is_tuned =
      changed_parameters(info.config, tuned_config()) < changed_parameters(info.config, Config{});
  return is_tuned ? kTunedTree : kPaperTree;
}

std::string broad_phase_of(const RecordingInfo& info) {
  return std::string(tree_of(info)) + (info.imported ? ", of imported boxes" : "");
}

template <int D>
Position parse_position(const std::string& option, const std::string& text,
                        const RecordingReader<D>& recording) {
  if (text.starts_with("e")) {
    const auto number = parse_number<std::uint64_t>(std::string_view(text).substr(1));
    if (!number) throw UsageError(option + " '" + text + "' is no event such as e1234");
    const auto step = recording.step_of(*number);
    if (!step) throw UsageError(option + " " + text + ": the recording ends before that event");
    return {*step, *number};
  }
  const GivenNames& names = recording.info().names;
  if (!parse_step_time(text))
    throw UsageError(option + " '" + text + "' is neither a step such as " +
                     names.step(std::min(recording.steps(), 17U)) + " nor an event such as e1234");
  const auto step = names.find_step(text);
  if (!step || *step > recording.steps())
    throw UsageError(option + " " + text + ": there is no such step; the recording goes from step " +
                     names.step(1) + " to " + names.step(recording.steps()));
  return Position::end_of(*step);
}

template Position parse_position<2>(const std::string&, const std::string&, const RecordingReader<2>&);
template Position parse_position<3>(const std::string&, const std::string&, const RecordingReader<3>&);

}  // namespace kerf

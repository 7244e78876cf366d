#include "core/recording/recording_reader.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/recording/keyframe_codec.h"
#include "core/recording/schema.h"
#include "core/recording/their_rows.h"

namespace kerf {
namespace {

std::uint64_t natural(const Statement& row, int& column) {
  return static_cast<std::uint64_t>(row.integer(column++));
}

std::uint32_t small(const Statement& row, int& column) {
  return static_cast<std::uint32_t>(row.integer(column++));
}

StepRow read_row(const Statement& row) {
  int column = 0;
  StepRow result;
  Statistics& s = result.statistics;
  result.step = small(row, column);
  s.objects = small(row, column);
  result.changed = natural(row, column);
  result.pairs = natural(row, column);
  s.height = small(row, column);
  s.leaves = small(row, column);
  s.entries = natural(row, column);
  s.redundancy = row.real(column++);
  for (std::uint64_t& acted : s.operators) acted = natural(row, column);
  s.refused = natural(row, column);
  s.deferred = small(row, column);
  s.placed = natural(row, column);
  result.first_event = natural(row, column);
  result.events = natural(row, column);
  for (double& seconds : s.phase_seconds) seconds = row.real(column++);
  result.state_hash = natural(row, column);
  result.pairs_hash = natural(row, column);
  return result;
}

}  // namespace

RecordingInfo read_recording_info(const std::filesystem::path& path) {
  return read_info(open_recording(path));
}

template <int D>
RecordingReader<D>::RecordingReader(const std::filesystem::path& path)
    : database_(open_recording(path)), info_(read_info(database_)) {
  if (info_.dimension != D)
    throw std::runtime_error(path.string() + " is a recording in " + std::to_string(info_.dimension) + "D");
  database_.execute("BEGIN");  // one state of the file from now on, whoever goes on writing
  read_rows();
}

/// Rows and blocks are committed together, so that they always end with the same step.
template <int D>
void RecordingReader<D>::read_rows() {
  Statement rows = database_.prepare("SELECT * FROM steps ORDER BY step");
  while (rows.step()) {
    rows_.push_back(read_row(rows));
    if (rows_.back().step != rows_.size())
      throw std::runtime_error("the recording is damaged: step " + std::to_string(rows_.size()) +
                               " is missing");
  }
  Statement keyframes = database_.prepare("SELECT step FROM keyframes ORDER BY step");
  while (keyframes.step()) keyframes_.push_back(static_cast<std::uint32_t>(keyframes.integer(0)));
}

template <int D>
std::optional<std::uint32_t> RecordingReader<D>::step_of(std::uint64_t event) const {
  const auto after = std::ranges::upper_bound(rows_, event, {}, &StepRow::first_event);
  if (after == rows_.begin()) return std::nullopt;
  const StepRow& row = *std::prev(after);
  if (event - row.first_event >= row.events) return std::nullopt;
  return row.step;
}

template <int D>
Event RecordingReader<D>::event(std::uint64_t id) {
  const auto of = step_of(id);
  if (!of) throw std::runtime_error("the recording has no event e" + std::to_string(id));
  return step(*of).events.at(id - row(*of).first_event);
}

template <int D>
std::vector<std::uint64_t> RecordingReader<D>::events_of_node(NodeId node) const {
  std::vector<std::uint64_t> ids;
  Statement rows = database_.prepare("SELECT id FROM events WHERE node = ? ORDER BY id");
  rows.bind(1, std::int64_t{node.value});
  while (rows.step()) ids.push_back(static_cast<std::uint64_t>(rows.integer(0)));
  return ids;
}

template <int D>
std::uint32_t RecordingReader<D>::keyframe_before(std::uint32_t step) const {
  const auto after = std::ranges::upper_bound(keyframes_, step);
  return after == keyframes_.begin() ? 0 : *std::prev(after);
}

template <int D>
BspState<D> RecordingReader<D>::keyframe(std::uint32_t step,
                                         std::shared_ptr<const Projector<D>> projector) const {
  return decode_keyframe<D>(keyframe_bytes(step), std::move(projector));
}

template <int D>
Bytes RecordingReader<D>::keyframe_bytes(std::uint32_t step) const {
  Statement row = database_.prepare("SELECT data FROM keyframes WHERE step = ?");
  if (!row.bind(1, std::int64_t{step}).step())
    throw std::runtime_error("the recording has no keyframe at step " + std::to_string(step));
  return row.bytes(0);
}

template <int D>
const RecordedStep<D>& RecordingReader<D>::step(std::uint32_t step) {
  if (step == 0 || step > steps())
    throw std::runtime_error("the recording has steps 1 to " + std::to_string(steps()) + ", no step " +
                             std::to_string(step));
  const auto holds = [step](const Span& span) {
    return step >= span.first && step - span.first < span.steps.size();
  };
  auto found = std::ranges::find_if(spans_, holds);
  if (found == spans_.end()) {
    if (spans_.size() >= kSpans) spans_.pop_back();
    found = spans_.insert(spans_.begin(), read_span(keyframe_before(step - 1)));
    if (!holds(*found))
      throw std::runtime_error("the recording is damaged: the block of step " + std::to_string(step) +
                               " is missing");
  }
  spans_.splice(spans_.begin(), spans_, found);
  return found->steps[step - found->first];
}

/// Each block goes on from what the one before has taught the decoder; a keyframe begins afresh.
template <int D>
auto RecordingReader<D>::read_span(std::uint32_t keyframe) const -> Span {
  Span span{keyframe + 1, {}};
  BlockDecoder<D> decoder(info_.volume);
  if (keyframe > 0) decoder.restart(decode_keyframe_objects<D>(keyframe_bytes(keyframe), info_.volume));
  const auto next = std::ranges::upper_bound(keyframes_, keyframe);
  const std::uint32_t end = next == keyframes_.end() ? steps() : *next;
  Statement blocks =
      database_.prepare("SELECT data FROM blocks WHERE first_step BETWEEN ? AND ? ORDER BY first_step");
  blocks.bind(1, std::int64_t{span.first}).bind(2, std::int64_t{end});
  while (blocks.step()) read_block(decoder, blocks.bytes(0), span);
  return span;
}

template <int D>
void RecordingReader<D>::read_block(BlockDecoder<D>& decoder, const Bytes& block, Span& span) const {
  const std::uint32_t first = span.first + static_cast<std::uint32_t>(span.steps.size());
  if (first > steps()) throw std::runtime_error("the recording is damaged: it has more blocks than steps");
  try {
    decoder.read(block, first, row(first).first_event, span.steps);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + " (block of step " + std::to_string(first) + ")");
  }
}

template <int D>
std::vector<Pair> RecordingReader<D>::their_pairs(std::uint32_t step) const {
  return read_their_pairs(database_, step);
}

template <int D>
std::optional<TheirStep> RecordingReader<D>::their_step(std::uint32_t step) const {
  return read_their_step(database_, step);
}

template <int D>
std::vector<JudgedPair> RecordingReader<D>::judged_pairs(std::uint32_t step) const {
  return read_judged_pairs(database_, step);
}

template <int D>
TheirChanges<D> RecordingReader<D>::their_changes(std::uint32_t step) const {
  return read_their_changes<D>(database_, step);
}

template <int D>
std::optional<GivenBox<D>> RecordingReader<D>::given_box(ObjectId object, std::uint32_t step) const {
  return read_given_box<D>(database_, object, step);
}

template <int D>
bool RecordingReader<D>::has_filters() const {
  return database_.ask("SELECT EXISTS(SELECT 1 FROM their_filters)") != 0;
}

template <int D>
std::optional<GivenFilter> RecordingReader<D>::filter(ObjectId object, std::uint32_t step) const {
  return read_filter(database_, object, step);
}

template <int D>
RecordingSize RecordingReader<D>::size() const {
  const auto ask = [this](std::string_view sql) { return static_cast<std::uint64_t>(database_.ask(sql)); };
  return {ask("SELECT sum(length(data)) FROM blocks"), ask("SELECT sum(length(data)) FROM keyframes"),
          ask("SELECT sum(changed) FROM blocks")};
}

template class RecordingReader<2>;
template class RecordingReader<3>;

}  // namespace kerf

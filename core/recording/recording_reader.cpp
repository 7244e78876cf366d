#include "core/recording/recording_reader.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/damage.h"
#include "core/base/float_mode.h"
#include "core/recording/chain.h"
#include "core/recording/keyframe_codec.h"
#include "core/recording/schema.h"
#include "core/recording/shape_rows.h"
#include "core/recording/their_rows.h"
#include "core/recording/unfinished.h"

namespace kerf {
namespace {

/// The step in a block must be that of its row.
template <int D>
void check_step(const RecordedStep<D>& step, const StepRow& row, const GivenNames& names) {
  if (step.changed != row.changed)
    fail_damaged("step " + names.step(row.step) + " has other changes in its block than its row says");
}

/// Whether SQLite could not read a page. A page that is not in the file is called an invalid number.
bool is_page_not_got(const std::string& finding) {
  return finding.find("failed to get page") != std::string::npos ||
         finding.find("unable to get the page") != std::string::npos;
}

/// Throws if the disk does not give what is on it.
void read_through(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, std::size_t{1} << 14U> piece{};
  while (file.read(piece.data(), piece.size())) continue;
  if (!file.eof()) throw std::runtime_error(path.string() + ": it cannot be read to its end");
}

/// The keyframe must be that of its step, as the step's row and the recording say.
template <int D>
void check_keyframe(const BspState<D>& state, const StepRow& row, const RecordingInfo& info) {
  const auto expect = [&](bool holds, const char* what) {
    if (!holds)
      fail_damaged("the keyframe of step " + info.names.step(row.step) + " has another " + what +
                   " than its step");
  };
  expect(state.step == row.step, "number");
  expect(state.config == config_of(info, row.step), "configuration");
  expect(state.next_event == row.first_event + row.events, "last event");
  expect(state.placed == row.statistics.placed, "count of placements");
  expect(state.scheduler.acted() == row.statistics.operators &&
             state.scheduler.refused() == row.statistics.refused,
         "count of operators");
  expect(state.hash() == row.state_hash, "state hash");
}

}  // namespace

RecordingInfo read_recording_info(const std::filesystem::path& path) {
  return read_info(open_recording(path));
}

template <int D>
RecordingReader<D>::RecordingReader(const std::filesystem::path& path, AsItIs /*even if changed*/)
    : path_(recording_at(path)), database_(open_recording(path)), info_(read_info(database_)) {
  if (info_.dimension != D)
    throw std::runtime_error(path.string() + " is a recording in " + std::to_string(info_.dimension) + "D");
  database_.execute("BEGIN");  // rows, blocks and keyframes of one moment, even while it is being written
  rows_ = read_rows(database_, info_.names);
  chain_ = follow_chain(database_, rows_, info_.names);
  database_.execute("COMMIT");  // written data does not change, and a writer that ends need not wait
}

template <int D>
RecordingReader<D>::RecordingReader(const std::filesystem::path& path) : RecordingReader(path, AsItIs{}) {
  if (chain_.change)
    throw std::runtime_error(path.string() + " was changed after it was recorded: " + chain_.change->what +
                             ", is not what was written; `kerf verify` says more");
}

template <int D>
auto RecordingReader<D>::open_changed(const std::filesystem::path& path) -> std::unique_ptr<RecordingReader> {
  return std::unique_ptr<RecordingReader>(new RecordingReader(path, AsItIs{}));
}

template <int D>
std::optional<ChangedPart> RecordingReader<D>::added() const {
  return info_.complete ? find_added(database_, rows_) : std::nullopt;
}

template <int D>
std::optional<std::uint32_t> RecordingReader<D>::step_of(std::uint64_t event) const {
  const auto after = std::ranges::upper_bound(rows_.steps, event, {}, &StepRow::first_event);
  if (after == rows_.steps.begin()) return std::nullopt;
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
bool RecordingReader<D>::has_keyframe(std::uint32_t step) const {
  return step > 0 && keyframe_before(step) == step;
}

template <int D>
std::uint32_t RecordingReader<D>::keyframe_before(std::uint32_t step) const {
  const auto after = std::ranges::upper_bound(rows_.keyframes, step, {}, &KeyframeRow::step);
  return after == rows_.keyframes.begin() ? 0 : std::prev(after)->step;
}

template <int D>
BspState<D> RecordingReader<D>::keyframe(std::uint32_t step,
                                         std::shared_ptr<const Projector<D>> projector) const {
  const DefaultFloats floats;
  BspState<D> state = decode_keyframe<D>(keyframe_bytes(step).tree, std::move(projector));
  check_keyframe(state, row(step), info_);
  return state;
}

template <int D>
auto RecordingReader<D>::keyframe_bytes(std::uint32_t step) const -> KeyframeBytes {
  const auto found = std::ranges::lower_bound(rows_.keyframes, step, {}, &KeyframeRow::step);
  Statement data = database_.prepare("SELECT data, looks FROM keyframes WHERE step = ?");
  if (found == rows_.keyframes.end() || found->step != step || !data.bind(1, std::int64_t{step}).step())
    throw std::runtime_error("the recording has no keyframe at step " + info_.names.step(step));
  KeyframeBytes bytes{data.bytes(0), data.bytes(1)};
  if (seal_of_keyframe(row(step).link, step, bytes.tree, bytes.looks) != found->seal)
    fail_damaged("the keyframe of step " + info_.names.step(step) + " is not what was written");
  return bytes;
}

template <int D>
Looks<D> RecordingReader<D>::keyframe_looks(std::uint32_t step) const {
  const DefaultFloats floats;
  const KeyframeBytes bytes = keyframe_bytes(step);
  const auto objects = decode_keyframe_objects<D>(bytes.tree, info_.volume);
  return decode_looks(step, bytes, objects.bound());
}

template <int D>
Looks<D> RecordingReader<D>::decode_looks(std::uint32_t step, const KeyframeBytes& bytes,
                                          std::size_t bound) const {
  Looks<D> looks = kerf::decode_looks<D>(bytes.looks, bound);
  for (std::uint32_t id = 0; id < looks.bound(); ++id) check_look(looks.of({id}), step);
  return looks;
}

template <int D>
const std::vector<Shape<D>>& RecordingReader<D>::shapes() const {
  if (shapes_) return *shapes_;
  const DefaultFloats floats;
  std::vector<Shape<D>> shapes;
  Statement rows = database_.prepare("SELECT kind, data FROM shapes WHERE shape < ? ORDER BY shape");
  rows.bind(1, static_cast<std::int64_t>(shape_count()));
  while (rows.step()) {
    const auto number = static_cast<std::uint32_t>(shapes.size());
    const ShapeRow& known = rows_.shapes.at(number);
    const std::string kind = rows.text(0);
    const Bytes data = rows.bytes(1);
    if (seal_of_shape(row(known.step).link, number, kind, data) != known.seal)
      fail_damaged("shape " + std::to_string(number) + " is not what was written");
    shapes.push_back(decode_shape<D>(kind, data));
  }
  return shapes_.emplace(std::move(shapes));
}

template <int D>
void RecordingReader<D>::check_look(const Look<D>& look, std::uint32_t step) const {
  if (look.shape == kNoShape) return;
  if (look.shape >= rows_.shapes.size() || rows_.shapes[look.shape].step > step)
    fail_damaged("in step " + info_.names.step(step) + " there is no shape " + std::to_string(look.shape));
}

template <int D>
const RecordedStep<D>& RecordingReader<D>::step(std::uint32_t step) {
  const DefaultFloats floats;
  if (step == 0 || step > steps())
    throw std::runtime_error("the recording has " + info_.names.steps(1, steps()) + ", no step " +
                             info_.names.step(step));
  const auto holds = [step](const Span& span) {
    return step >= span.first && step - span.first < span.steps.size();
  };
  auto found = std::ranges::find_if(spans_, holds);
  if (found == spans_.end()) {
    if (spans_.size() >= kSpans) spans_.pop_back();
    found = spans_.insert(spans_.begin(), read_span(keyframe_before(step - 1)));
    if (!holds(*found))
      throw std::runtime_error("the recording is damaged: the block of step " + info_.names.step(step) +
                               " is missing");
  }
  spans_.splice(spans_.begin(), spans_, found);
  return found->steps[step - found->first];
}

/// Each block continues from what the decoder learnt from the one before; a keyframe begins afresh.
template <int D>
auto RecordingReader<D>::read_span(std::uint32_t keyframe) const -> Span {
  Span span{keyframe + 1, {}};
  BlockDecoder<D> decoder(info_.volume);
  if (keyframe > 0) {
    const KeyframeBytes bytes = keyframe_bytes(keyframe);
    const auto objects = decode_keyframe_objects<D>(bytes.tree, info_.volume);
    decoder.restart(objects, decode_looks(keyframe, bytes, objects.bound()));
  }
  const auto next = std::ranges::upper_bound(rows_.keyframes, keyframe, {}, &KeyframeRow::step);
  const std::uint32_t end = next == rows_.keyframes.end() ? steps() : next->step;
  for (auto block = std::ranges::lower_bound(rows_.blocks, span.first, {}, &BlockRow::first_step);
       block != rows_.blocks.end() && block->first_step <= end; ++block)
    read_block(decoder, *block, span);
  return span;
}

template <int D>
void RecordingReader<D>::read_block(BlockDecoder<D>& decoder, const BlockRow& block, Span& span) const {
  const std::string name = " (block of step " + info_.names.step(block.first_step) + ")";
  Statement data = database_.prepare("SELECT data FROM blocks WHERE first_step = ?");
  if (!data.bind(1, std::int64_t{block.first_step}).step()) fail_damaged("a block is missing" + name);
  const Bytes bytes = data.bytes(0);
  if (seal_of_block(row(block.last_step()).link, block.first_step, block.steps, block.changed, bytes) !=
      block.seal)
    fail_damaged("a block is not what was written" + name);
  try {
    decoder.read(bytes, std::span(rows_.steps).subspan(block.first_step - 1, block.steps), span.steps);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(error.what() + name);
  }
  for (std::uint32_t step = block.first_step; step <= block.last_step(); ++step) {
    const RecordedStep<D>& read = span.steps[step - span.first];
    check_step(read, row(step), info_.names);
    for (const LookChange<D>& change : read.looks) check_look(change.look, step);
  }
}

template <int D>
void RecordingReader<D>::check_theirs(std::uint32_t step) const {
  if (step == theirs_asked_) return;
  const auto found = std::ranges::lower_bound(rows_.theirs, step, {}, &TheirRow::step);
  const bool has_seal = found != rows_.theirs.end() && found->step == step;
  const auto seal = seal_of_theirs(row(step).link, database_, step);
  if (seal != (has_seal ? std::optional(found->seal) : std::nullopt))
    fail_damaged("what step " + info_.names.step(step) + " has of another engine is not what was written");
  theirs_asked_ = step;
}

template <int D>
std::vector<Pair> RecordingReader<D>::their_pairs(std::uint32_t step) const {
  check_theirs(step);
  return read_their_pairs(database_, step);
}

template <int D>
std::optional<TheirStep> RecordingReader<D>::their_step(std::uint32_t step) const {
  if (info_.imported || !rows_.theirs.empty()) check_theirs(step);
  return read_their_step(database_, step);
}

template <int D>
bool RecordingReader<D>::lacks_their_pairs(std::uint32_t step) const {
  return info_.imported && !info_.complete && step == steps() && !their_step(step) && !their_steps().empty();
}

/// `is_any`: there are rows of another engine. Where there are none any more, an import may have had some.
template <int D>
void RecordingReader<D>::check_all_theirs(bool is_any) const {
  if (!info_.imported && rows_.theirs.empty() && !is_any) return;
  for (; theirs_checked_ < steps(); ++theirs_checked_) check_theirs(theirs_checked_ + 1);
}

template <int D>
std::vector<std::pair<std::uint32_t, TheirStep>> RecordingReader<D>::their_steps() const {
  auto sums = read_their_steps(database_);
  check_all_theirs(!sums.empty());
  while (!sums.empty() && sums.back().first > steps()) sums.pop_back();  // still being written
  return sums;
}

template <int D>
std::vector<JudgedPair> RecordingReader<D>::judged_pairs(std::uint32_t step) const {
  check_theirs(step);
  return read_judged_pairs(database_, step);
}

template <int D>
TheirChanges<D> RecordingReader<D>::their_changes(std::uint32_t step) const {
  const DefaultFloats floats;
  check_theirs(step);
  return read_their_changes<D>(database_, step);
}

/// What an object was given last may stand in any step up to this one.
template <int D>
void RecordingReader<D>::check_theirs_up_to(std::uint32_t step) const {
  if (!info_.imported) return;
  for (; theirs_checked_ < std::min(step, steps()); ++theirs_checked_) check_theirs(theirs_checked_ + 1);
}

template <int D>
std::optional<GivenBox<D>> RecordingReader<D>::given_box(ObjectId object, std::uint32_t step) const {
  const DefaultFloats floats;
  check_theirs_up_to(step);
  return read_given_box<D>(database_, object, step);
}

template <int D>
bool RecordingReader<D>::has_filters() const {
  check_theirs_up_to(steps());
  return database_.ask("SELECT EXISTS(SELECT 1 FROM their_filters)") != 0;
}

template <int D>
std::optional<GivenFilter> RecordingReader<D>::filter(ObjectId object, std::uint32_t step) const {
  check_theirs_up_to(step);
  return read_filter(database_, object, step);
}

template <int D>
std::optional<TheirStructure<D>> RecordingReader<D>::their_structure(std::uint32_t step) const {
  const DefaultFloats floats;
  if (step == 0 || step > steps()) return std::nullopt;
  if (!has_structures(database_) && rows_.theirs.empty()) return std::nullopt;
  check_theirs(step);
  auto structure = read_structure<D>(database_, step);
  if (structure) structure->digits = info_.digits;
  return structure;
}

template <int D>
std::vector<std::uint32_t> RecordingReader<D>::structure_steps() const {
  std::vector<std::uint32_t> known = read_structure_steps(database_);
  check_all_theirs(!known.empty());
  while (!known.empty() && known.back() > steps()) known.pop_back();  // still being written
  return known;
}

template <int D>
RecordingSize RecordingReader<D>::size() const {
  const auto ask = [this](std::string_view sql) { return static_cast<std::uint64_t>(database_.ask(sql)); };
  return {ask("SELECT coalesce(sum(length(data)), 0) FROM blocks"),
          ask("SELECT coalesce(sum(length(data)), 0) FROM keyframes"),
          ask("SELECT coalesce(sum(changed), 0) FROM blocks")};
}

/// Indexes as well, by which SQL finds rows.
template <int D>
void RecordingReader<D>::check_pages() const {
  Statement check = database_.prepare("PRAGMA integrity_check(1)");
  const std::string finding = check.step() ? check.text(0) : "nothing was checked";
  if (is_page_not_got(finding)) {
    read_through(path_);
    throw std::bad_alloc();
  }
  if (finding != "ok") fail_damaged(finding);
  database_.check_size(path_);
}

template class RecordingReader<2>;
template class RecordingReader<3>;

}  // namespace kerf

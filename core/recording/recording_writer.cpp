#include "core/recording/recording_writer.h"

#include "core/base/float_mode.h"
#include "core/recording/keyframe_codec.h"
#include "core/recording/operator_rows.h"
#include "core/recording/schema.h"
#include "core/recording/their_rows.h"

namespace kerf {
namespace {

constexpr std::uint32_t kBlockSteps = 25;
constexpr auto kFlushInterval = std::chrono::seconds(1);
/// A keyframe every 16 to 256 steps: a seek replays from the last one, so the more a step costs, the closer
/// it must be. To replay a step without its pairs takes some 40 ns for each object and four times as long for
/// each that changes; 30 ms in all.
constexpr std::uint64_t kMostReplayed = 700'000;
constexpr std::uint64_t kCostOfChange = 4;
constexpr std::uint32_t kLeastSteps = 16;
constexpr std::uint32_t kMostSteps = 256;

Database create(const std::filesystem::path& path, const RecordingInfo& info) {
  const DefaultFloats floats;
  Database database = Database::create(path);
  create_schema(database, info);
  return database;
}

std::int64_t whole(std::uint64_t x) { return static_cast<std::int64_t>(x); }

}  // namespace

template <int D>
RecordingWriter<D>::RecordingWriter(const std::filesystem::path& path, const RecordingInfo& info)
    : database_(create(path, info)),
      chain_(head_of(database_)),
      put_step_(database_.prepare(
          "INSERT INTO steps VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)")),
      put_event_(database_.prepare(kPutOperator)),
      put_block_(database_.prepare("INSERT INTO blocks VALUES(?,?,?,?,?)")),
      put_keyframe_(database_.prepare("INSERT INTO keyframes VALUES(?,?,?,?)")),
      encoder_(info.volume),
      awaits_theirs_(info.imported),
      last_flush_(std::chrono::steady_clock::now()) {
  database_.execute("BEGIN");
  database_.keep();
}

template <int D>
void RecordingWriter<D>::add(const StepRequests<D>& requests, std::span<const Event> events, StepRow row,
                             std::span<const Look<D>> looks) {
  const DefaultFloats floats;
  seal_theirs();
  if (commits_later_) commit();
  step_ = row.step;
  row.changed = encoder_.add(requests, events, looks);
  changed_ += row.changed;
  since_keyframe_ += row.statistics.objects + kCostOfChange * row.changed;
  row.operators_hash = put(events);
  row.link = chain_.add(row);
  put(row);
  put_new_shapes();
  const bool due = std::chrono::steady_clock::now() - last_flush_ >= kFlushInterval;
  if (encoder_.steps() >= kBlockSteps || due || wants_keyframe()) flush();
}

template <int D>
bool RecordingWriter<D>::wants_keyframe() const {
  const std::uint32_t steps = step_ - last_keyframe_;
  return steps >= kMostSteps || (steps >= kLeastSteps && since_keyframe_ >= kMostReplayed);
}

template <int D>
void RecordingWriter<D>::add(const BspState<D>& keyframe) {
  const DefaultFloats floats;
  if (encoder_.steps() > 0) flush();
  const Bytes bytes = encode_keyframe(keyframe);
  const Bytes looks = encode_looks(encoder_.looks());
  const std::uint64_t seal = seal_of_keyframe(chain_.link(), keyframe.step, bytes, looks);
  put_keyframe_.bind(1, std::int64_t{keyframe.step}).bind(2, whole(seal));
  put_keyframe_.bind(3, std::span(bytes)).bind(4, std::span(looks)).run();
  chain_.add(Chain::Part::keyframe, seal);
  encoder_.restart(keyframe.latest);
  last_keyframe_ = keyframe.step;
  since_keyframe_ = 0;
}

template <int D>
void RecordingWriter<D>::add(const TheirChanges<D>& changes) {
  const DefaultFloats floats;
  has_theirs_ = true;
  write_changes(database_, step_, changes);
}

template <int D>
void RecordingWriter<D>::add(std::span<const Pair> their_pairs, std::span<const JudgedPair> judged) {
  has_theirs_ = true;
  write_theirs(database_, step_, their_pairs, judged);
}

template <int D>
void RecordingWriter<D>::add(const TheirStructure<D>& structure) {
  const DefaultFloats floats;
  has_theirs_ = true;
  write_structure(database_, step_, structure);
}

template <int D>
void RecordingWriter<D>::put(const StepRow& row) {
  const Statistics& s = row.statistics;
  int place = 0;
  const auto next = [&](auto value) { put_step_.bind(++place, value); };
  for (const std::uint64_t x : {std::uint64_t{row.step}, std::uint64_t{s.objects}, row.changed, row.pairs,
                                std::uint64_t{s.height}, std::uint64_t{s.leaves}, s.entries})
    next(whole(x));
  next(s.redundancy);
  for (const std::uint64_t acted : s.operators) next(whole(acted));
  for (const std::uint64_t x :
       {s.refused, std::uint64_t{s.deferred}, s.placed, row.first_event, row.events, row.operators_hash})
    next(whole(x));
  for (const double seconds : s.phase_seconds) next(seconds);
  for (const std::uint64_t x : {row.state_hash, row.pairs_hash, row.link}) next(whole(x));
  put_step_.run();
}

/// Operators, refusals and schedulings are rows for SQL; phases and placements are only in the blocks.
/// Returns the hash of the rows.
template <int D>
std::uint64_t RecordingWriter<D>::put(std::span<const Event> events) {
  std::uint64_t hash = 0;
  for (const Event& event : events) {
    const auto row = operator_row(event);
    if (!row) continue;
    kerf::put(*row, put_event_);
    hash = hash_operator(*row, hash);
  }
  return hash;
}

template <int D>
void RecordingWriter<D>::put_new_shapes() {
  const auto shapes = shapes_.take_new();
  if (shapes.empty()) return;
  Statement put_shape = database_.prepare("INSERT INTO shapes VALUES(?,?,?,?,?)");
  std::vector<std::uint64_t> seals;
  for (const auto& [number, text] : shapes) {
    seals.push_back(seal_of_shape(chain_.link(), number, text.kind, text.data));
    put_shape.bind(1, std::int64_t{number}).bind(2, std::int64_t{step_}).bind(3, text.kind);
    put_shape.bind(4, whole(seals.back())).bind(5, std::span(text.data)).run();
  }
  chain_.add(Chain::Part::shapes, seal_of_shapes(seals));
}

/// Seals the data of another engine after the last step.
template <int D>
void RecordingWriter<D>::seal_theirs() {
  if (!has_theirs_) return;
  has_theirs_ = false;
  const auto seal = seal_of_theirs(chain_.link(), database_, step_);
  if (!seal) return;
  Statement put_seal = database_.prepare("INSERT INTO their_seals VALUES(?,?)");
  put_seal.bind(1, std::int64_t{step_}).bind(2, whole(*seal)).run();
  chain_.add(Chain::Part::theirs, *seal);
}

template <int D>
void RecordingWriter<D>::flush() {
  const std::uint32_t steps = encoder_.steps();
  const Bytes block = encoder_.take();
  const std::uint32_t first = step_ + 1 - steps;
  const std::uint64_t seal = seal_of_block(chain_.link(), first, steps, changed_, block);
  put_block_.bind(1, std::int64_t{first}).bind(2, std::int64_t{steps}).bind(3, whole(changed_));
  put_block_.bind(4, whole(seal)).bind(5, std::span(block)).run();
  chain_.add(Chain::Part::block, seal);
  changed_ = 0;
  commits_later_ = awaits_theirs_;
  if (!commits_later_) commit();
}

template <int D>
void RecordingWriter<D>::commit() {
  commits_later_ = false;
  database_.execute("COMMIT");
  committed_ = step_;
  database_.execute("BEGIN");
  last_flush_ = std::chrono::steady_clock::now();
}

template <int D>
void RecordingWriter<D>::finish() {
  seal_theirs();
  if (encoder_.steps() > 0) flush();
  set_complete(database_, chain_.end());
  database_.execute("COMMIT");
  committed_ = step_;
  put_step_.end();
  put_event_.end();
  put_block_.end();
  put_keyframe_.end();
  database_.close();
}

template class RecordingWriter<2>;
template class RecordingWriter<3>;

}  // namespace kerf

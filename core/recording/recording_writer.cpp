#include "core/recording/recording_writer.h"

#include "core/recording/keyframe_codec.h"
#include "core/recording/schema.h"
#include "core/recording/their_rows.h"

namespace kerf {
namespace {

constexpr std::uint32_t kBlockSteps = 25;
constexpr auto kFlushInterval = std::chrono::seconds(1);
/// A keyframe every 16 to 256 steps: a seek replays from the last one, so the more a step costs, the nearer
/// it must be. To replay a step whose pairs nobody asks for takes some 40 ns for each object and four times
/// as long for each that changes; 30 ms in all.
constexpr std::uint64_t kMostReplayed = 700'000;
constexpr std::uint64_t kCostOfChange = 4;
constexpr std::uint32_t kLeastSteps = 16;
constexpr std::uint32_t kMostSteps = 256;

Database create(const std::filesystem::path& path, const RecordingInfo& info) {
  Database database = Database::create(path);
  create_schema(database, info);
  return database;
}

std::int64_t whole(std::uint64_t x) { return static_cast<std::int64_t>(x); }

}  // namespace

template <int D>
RecordingWriter<D>::RecordingWriter(const std::filesystem::path& path, const RecordingInfo& info)
    : database_(create(path, info)),
      put_step_(
          database_.prepare("INSERT INTO steps VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)")),
      put_event_(database_.prepare("INSERT INTO events VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)")),
      put_block_(database_.prepare("INSERT INTO blocks VALUES(?,?,?,?)")),
      put_keyframe_(database_.prepare("INSERT INTO keyframes VALUES(?,?)")),
      encoder_(info.volume),
      last_flush_(std::chrono::steady_clock::now()) {
  database_.execute("BEGIN");
}

template <int D>
void RecordingWriter<D>::add(const StepRequests<D>& requests, std::span<const Event> events, StepRow row) {
  step_ = row.step;
  row.changed = encoder_.add(requests, events);
  changed_ += row.changed;
  since_keyframe_ += row.statistics.objects + kCostOfChange * row.changed;
  put(row);
  for (const Event& event : events) put(event);
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
  if (encoder_.steps() > 0) flush();
  const Bytes bytes = encode_keyframe(keyframe);
  put_keyframe_.bind(1, std::int64_t{keyframe.step}).bind(2, std::span(bytes)).run();
  encoder_.restart(keyframe.latest);
  last_keyframe_ = keyframe.step;
  since_keyframe_ = 0;
}

template <int D>
void RecordingWriter<D>::add(const TheirChanges<D>& changes) {
  write_changes(database_, step_, changes);
}

template <int D>
void RecordingWriter<D>::add(std::span<const Pair> their_pairs, std::span<const JudgedPair> judged) {
  write_theirs(database_, step_, their_pairs, judged);
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
  for (const std::uint64_t x : {s.refused, std::uint64_t{s.deferred}, s.placed, row.first_event, row.events})
    next(whole(x));
  for (const double seconds : s.phase_seconds) next(seconds);
  next(whole(row.state_hash));
  next(whole(row.pairs_hash));
  put_step_.run();
}

/// Operators, refusals and what was scheduled are there for SQL; phases and placements are in the blocks
/// only.
template <int D>
void RecordingWriter<D>::put(const Event& event) {
  const auto put_operator = [&](std::string_view kind, Operator op, const NodeRef& node) -> Statement& {
    put_event_.clear();
    put_event_.bind(1, whole(event.id)).bind(2, std::int64_t{event.step}).bind(3, kind);
    put_event_.bind(4, to_string(op)).bind(5, std::int64_t{node.node.value});
    return put_event_.bind(6, std::int64_t{node.generation});
  };
  if (const auto* acted = std::get_if<OperatorActed>(&event.body)) {
    put_operator("acted", acted->op, acted->node);
    int place = 6;
    for (const std::uint32_t x : {acted->before.population, acted->before.left, acted->before.right,
                                  acted->after.left, acted->after.right, acted->direction})
      put_event_.bind(++place, std::int64_t{x});
    put_event_.bind(13, static_cast<double>(acted->old_offset))
        .bind(14, static_cast<double>(acted->new_offset));
    put_event_.run();
  } else if (const auto* refused = std::get_if<OperatorRefused>(&event.body)) {
    put_operator("refused", refused->op, refused->node).bind(15, to_string(refused->reason)).run();
  } else if (const auto* scheduled = std::get_if<OperatorScheduled>(&event.body)) {
    put_operator("scheduled", scheduled->op, scheduled->node).run();
  }
}

template <int D>
void RecordingWriter<D>::flush() {
  const std::uint32_t steps = encoder_.steps();
  const Bytes block = encoder_.take();
  put_block_.bind(1, std::int64_t{step_ + 1 - steps}).bind(2, std::int64_t{steps});
  put_block_.bind(3, whole(changed_)).bind(4, std::span(block)).run();
  changed_ = 0;
  database_.execute("COMMIT; BEGIN");
  last_flush_ = std::chrono::steady_clock::now();
}

template <int D>
void RecordingWriter<D>::finish() {
  if (encoder_.steps() > 0) flush();
  set_meta(database_, "complete", "1");
  database_.execute("COMMIT");
  put_step_.end();
  put_event_.end();
  put_block_.end();
  put_keyframe_.end();
  database_.close();
}

template class RecordingWriter<2>;
template class RecordingWriter<3>;

}  // namespace kerf

#include "frames/commands/export_recording.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "core/base/shortest_text.h"
#include "core/replay/judge_theirs.h"
#include "core/trace/event_facts.h"
#include "frames/page/json.h"
#include "frames/support/utf8.h"

namespace kerf {
namespace {

constexpr double kMicro = 1e6;

/// Slices of one step from `start` on, in microseconds; returns where operators begin.
double put_slices(const StepRow& row, const GivenNames& names, double start, std::ostream& out) {
  const Json step{{"name", "step " + names.step(row.step)},
                  {"ph", "X"},
                  {"pid", 1},
                  {"tid", 1},
                  {"ts", start},
                  {"dur", kMicro * row.seconds()},
                  {"args", {{"objects", row.statistics.objects}, {"changed", row.changed}}}};
  out << step << ",\n";
  double begin = start;
  double operators = start;
  for (int phase = 0; phase < kPhaseCount; ++phase) {
    const double duration = kMicro * row.statistics.phase_seconds[static_cast<std::size_t>(phase)];
    if (static_cast<Phase>(phase) == Phase::operate) operators = begin;
    out << Json{{"name", to_string(static_cast<Phase>(phase))},
                {"ph", "X"},
                {"pid", 1},
                {"tid", 1},
                {"ts", begin},
                {"dur", duration}}
        << ",\n";
    begin += duration;
  }
  return operators;
}

void put_counters(const StepRow& row, double at, std::ostream& out) {
  const auto counter = [&](const char* name, double value) {
    out << Json{{"name", name}, {"ph", "C"}, {"pid", 1}, {"ts", at}, {"args", {{name, value}}}} << ",\n";
  };
  counter("pairs", static_cast<double>(row.pairs));
  counter("entries", static_cast<double>(row.statistics.entries));
  counter("deferred", row.statistics.deferred);
  counter("redundancy", row.statistics.redundancy);
}

/// What a step says of an object.
template <int D>
struct BoxRow {
  ObjectId object;
  std::optional<Box<D>> box;  ///< none: it goes
  bool fixed = false;
  bool was_removed = false;  ///< just before, to come with another mobility
};

/// The requests of the steps as rows that `kerf import` makes the same requests of.
template <int D>
class BoxRows {
 public:
  explicit BoxRows(RecordingReader<D>& recording) : recording_(recording) {}

  /// To be asked step by step. Valid until the next call.
  const std::vector<BoxRow<D>>& next(std::uint32_t step) {
    rows_.clear();
    last_.clear();
    for_each_request(recording_.step(step).requests, recording_.info().volume,
                     [&](const ObjectRequest<D>& request) { add(request); });
    return rows_;
  }

 private:
  /// Of several boxes of an object the last counts. One that goes and comes at once with another mobility has
  /// one row: an object of a tree keeps its mobility.
  void add(const ObjectRequest<D>& request) {
    const ObjectId object = request.object;
    const auto last = last_.find(object);
    if (request.kind == RequestKind::remove) {
      last_.erase(object);
      rows_.push_back({object, std::nullopt, false});
      return;
    }
    if (!is_insert(request.kind) && last != last_.end()) {
      rows_[last->second].box = request.volume.box;
      return;
    }
    bool& fixed = fixed_[object];
    const bool was_fixed = fixed;
    if (is_insert(request.kind)) fixed = request.mobility == Mobility::fixed;
    const bool is_changed = !rows_.empty() && rows_.back().object == object && fixed != was_fixed;
    const bool was_removed = is_changed && !rows_.back().box;
    if (was_removed) rows_.pop_back();
    last_[object] = rows_.size();
    rows_.push_back({object, request.volume.box, fixed, was_removed});
  }

  RecordingReader<D>& recording_;
  std::vector<BoxRow<D>> rows_;
  std::unordered_map<ObjectId, std::size_t> last_;  ///< the row of an object's box in this step
  std::unordered_map<ObjectId, bool> fixed_;
};

/// A bound as it was written: zeros behind the point show that all have so many decimals, and exponents that
/// zeros before it are no digits.
std::string bound_text(double bound, const BoundRounding& rounding) {
  const bool is_rounded = rounding.decimals > 0 || rounding.digits > 0;
  if (!is_rounded || !std::isfinite(bound)) return shortest_text(bound);
  std::array<char, 400> text{};
  const auto format = rounding.decimals > 0 ? std::chars_format::fixed : std::chars_format::general;
  const auto count = static_cast<int>(rounding.decimals > 0 ? rounding.decimals : rounding.digits);
  const auto end = std::to_chars(text.begin(), text.end(), bound, format, count).ptr;
  return {text.begin(), end};
}

/// Prints rows with the names and numbers that were given.
template <int D>
class BoxPrinter {
 public:
  BoxPrinter(const RecordingReader<D>& recording, std::ostream& out)
      : names_(recording.info().names),
        rounding_(recording.info().design.rounding),
        has_filters_(recording.has_filters()),
        out_(out) {
    out_ << "step,object,min_x,max_x,min_y,max_y" << (D == 3 ? ",min_z,max_z" : "") << ",fixed"
         << (has_filters_ ? ",category,mask" : "") << '\n';
  }

  void put(std::uint32_t step, const std::vector<BoxRow<D>>& rows, const TheirChanges<D>& changes) {
    filters_.clear();
    repeated_.clear();
    for (const auto& [object, filter] : changes.filters) {
      filters_[object] = filter;
      if (filter == world_.filter(object)) repeated_.insert(object);
    }
    world_.apply(changes);
    for (const BoxRow<D>& row : rows) {
      if (row.was_removed && repeated_.contains(row.object)) put(step, {row.object, std::nullopt});
      put(step, row);
    }
    if (rows.empty())
      out_ << names_.step(step) << std::string(2 * D + 2 + (has_filters_ ? 2 : 0), ',') << '\n';
  }

 private:
  void put(std::uint32_t step, const BoxRow<D>& row) {
    out_ << names_.step(step) << ',' << names_.object(row.object);
    const auto& given = world_.given(row.object);
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!row.box) out_ << ",,";
      if (!row.box) continue;
      const GivenBox<D> box = given ? *given : to_given(*row.box);
      out_ << ',' << bound_text(box.min[axis], rounding_) << ',' << bound_text(box.max[axis], rounding_);
    }
    out_ << ',' << (row.box ? (row.fixed ? "1" : "0") : "");
    if (has_filters_) put_filter(row.object);
    out_ << '\n';
  }

  void put_filter(ObjectId object) {
    const auto changed = filters_.find(object);
    if (changed == filters_.end()) {
      out_ << ",,";
    } else {
      out_ << ',' << changed->second.category << ',' << changed->second.mask;
    }
  }

  const GivenNames& names_;
  BoundRounding rounding_;
  bool has_filters_;
  std::ostream& out_;
  TheirWorld<D> world_;
  std::unordered_map<ObjectId, GivenFilter> filters_;  ///< that change in the step
  std::unordered_set<ObjectId>
      repeated_;  ///< of objects that came anew in the step, with the filter they had
};

}  // namespace

template <int D>
void export_chrome_trace(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  double time = 0;
  out << "{\"traceEvents\":[\n";
  for (const StepRow& row : recording.rows()) {
    on_step(row.step);
    const double operators = put_slices(row, recording.info().names, time, out);
    put_counters(row, time, out);
    for (const Event& event : recording.step(row.step).events)
      if (has_acted(event))
        out << Json{{"name", describe(event, recording.info().names)},
                    {"ph", "i"},
                    {"s", "t"},
                    {"pid", 1},
                    {"tid", 1},
                    {"ts", operators}}
            << ",\n";
    time += kMicro * row.seconds();
  }
  out << Json{{"name", "process_name"},
              {"ph", "M"},
              {"pid", 1},
              {"args", {{"name", valid_utf8(recording.info().scene)}}}}
      << "\n]}\n";
}

template <int D>
void export_steps(const RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  out << "step,objects,changed,pairs,height,leaves,entries,redundancy,balances,shift_splits,splits,swaps,"
         "merges,refused,"
         "deferred,placed,first_event,events,place_seconds,sort_seconds,schedule_seconds,operate_seconds,"
         "sweep_seconds,"
         "state_hash\n";
  for (const StepRow& row : recording.rows()) {
    on_step(row.step);
    const Statistics& s = row.statistics;
    out << recording.info().names.step(row.step) << ',' << s.objects << ',' << row.changed << ',' << row.pairs
        << ',' << s.height << ',' << s.leaves << ',' << s.entries << ',' << s.redundancy;
    for (const std::uint64_t acted : s.operators) out << ',' << acted;
    out << ',' << s.refused << ',' << s.deferred << ',' << s.placed << ',' << row.first_event << ','
        << row.events;
    for (const double seconds : s.phase_seconds) out << ',' << seconds;
    out << ',' << to_hex(row.state_hash) << '\n';
  }
}

template <int D>
void export_boxes(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  BoxRows<D> rows(recording);
  BoxPrinter<D> printer(recording, out);
  for (std::uint32_t step = 1; step <= recording.steps(); ++step) {
    on_step(step);
    const bool imported = recording.info().imported;
    printer.put(step, rows.next(step), imported ? recording.their_changes(step) : TheirChanges<D>());
  }
}

template <int D>
void export_pairs(const RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  const GivenNames& names = recording.info().names;
  out << "step,a,b\n";
  for (std::uint32_t step = 1; step <= recording.steps(); ++step) {
    on_step(step);
    for (const Pair& pair : recording.their_pairs(step))
      out << names.step(step) << ',' << names.pair(pair) << '\n';
  }
}

#define KERF_INSTANTIATE(D)                                                                \
  template void export_chrome_trace<D>(RecordingReader<D>&, std::ostream&, const OnStep&); \
  template void export_steps<D>(const RecordingReader<D>&, std::ostream&, const OnStep&);  \
  template void export_boxes<D>(RecordingReader<D>&, std::ostream&, const OnStep&);        \
  template void export_pairs<D>(const RecordingReader<D>&, std::ostream&, const OnStep&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

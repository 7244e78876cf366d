#include "frames/commands/export_recording.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/trace/event_facts.h"
#include "frames/support/utf8.h"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMicro = 1e6;

/// Slices of one step from `start` on, in microseconds; returns where operators begin.
double put_slices(const StepRow& row, double start, std::ostream& out) {
  const Json step{{"name", "step " + std::to_string(row.step)},
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

/// The shortest text that reads back as the same float.
std::string exact(Scalar x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

template <int D>
void put_box(std::uint32_t step, ObjectId object, const Box<D>* box, bool fixed, std::ostream& out) {
  out << step << ',' << object.value;
  for (int axis = 0; axis < D; ++axis)
    out << ',' << (box == nullptr ? "" : exact(box->min[axis])) << ','
        << (box == nullptr ? "" : exact(box->max[axis]));
  out << ',' << (fixed ? 1 : 0) << '\n';
}

}  // namespace

template <int D>
void export_chrome_trace(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  double time = 0;
  out << "{\"traceEvents\":[\n";
  for (const StepRow& row : recording.rows()) {
    on_step(row.step);
    const double operators = put_slices(row, time, out);
    put_counters(row, time, out);
    for (const Event& event : recording.step(row.step).events)
      if (has_acted(event))
        out << Json{{"name", describe(event)}, {"ph", "i"}, {"s", "t"}, {"pid", 1}, {"tid", 1},
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
    out << row.step << ',' << s.objects << ',' << row.changed << ',' << row.pairs << ',' << s.height << ','
        << s.leaves << ',' << s.entries << ',' << s.redundancy;
    for (const std::uint64_t acted : s.operators) out << ',' << acted;
    out << ',' << s.refused << ',' << s.deferred << ',' << s.placed << ',' << row.first_event << ','
        << row.events;
    for (const double seconds : s.phase_seconds) out << ',' << seconds;
    out << ',' << to_hex(row.state_hash) << '\n';
  }
}

template <int D>
void export_boxes(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step) {
  out << "step,object,min_x,max_x,min_y,max_y" << (D == 3 ? ",min_z,max_z" : "") << ",fixed\n";
  std::vector<bool> fixed;
  for (std::uint32_t step = 1; step <= recording.steps(); ++step) {
    on_step(step);
    const StepRequests<D>& requests = recording.step(step).requests;
    std::size_t k = 0;
    for (const Call& call : requests.calls) {
      for (const std::size_t end = k + call.count; k < end; ++k) {
        const ObjectId object = requests.objects[k];
        if (fixed.size() <= object.index()) fixed.resize(object.index() + 1);
        if (is_insert(call.kind)) fixed[object.index()] = call.mobility == Mobility::fixed;
        const Box<D>* const box = call.kind == RequestKind::remove ? nullptr : &requests.boxes[k];
        put_box(step, object, box, fixed[object.index()], out);
      }
    }
  }
}

#define KERF_INSTANTIATE(D)                                                                \
  template void export_chrome_trace<D>(RecordingReader<D>&, std::ostream&, const OnStep&); \
  template void export_steps<D>(const RecordingReader<D>&, std::ostream&, const OnStep&);  \
  template void export_boxes<D>(RecordingReader<D>&, std::ostream&, const OnStep&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

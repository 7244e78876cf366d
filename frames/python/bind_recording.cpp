#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <optional>

#include "core/query/search.h"
#include "frames/python/bindings.h"
#include "frames/python/config_from.h"
#include "frames/python/errors.h"
#include "frames/python/pickling.h"
#include "frames/python/recorded_rows.h"
#include "frames/python/recording.h"

namespace kerf::python {
namespace {

namespace py = pybind11;
using Opened = PythonRecording;

constexpr const char* kRecordingClass =
    R"(A recorded run: what was asked of the tree in each step, and what it did.

    run = kerf.Recording("pile.kerf")
    run.rows["pairs"]                          # of each step
    run.pairs(17), run.boxes(17)               # at the end of step 17
    moment = run.find("op==merge && depth>8")  # a condition, as of `kerf step` and the debugger

Steps count from 1; step 0 is before the first. A recording that is still being written has the steps that it had
when it was opened. Objects and steps of an import have the recording's own numbers; .object_names and .step_names
have the other engine's.

Whatever is wrong with the file, or is not in it, raises kerf.RecordingError.)";

std::optional<std::uint64_t> event_of(const Position& at) {
  return at.is_end() ? std::nullopt : std::optional(at.event);
}

/// A `kerf.Moment`, which __init__ defines.
py::object moment(const Position& at) {
  return py::module_::import("kerf").attr("Moment")(at.step, event_of(at));
}

/// A step, or a tuple of a step and an event or None. Throws ValueError for anything else.
Position position_from(const py::handle& given) {
  try {
    if (PyIndex_Check(given.ptr()) != 0) return Position::end_of(given.cast<std::uint32_t>());
    const auto pair = given.cast<std::pair<std::uint32_t, std::optional<std::uint64_t>>>();
    return {pair.first, pair.second.value_or(Position::kEnd)};
  } catch (const py::cast_error&) {
    throw py::value_error("after, before: " + std::string(py::repr(given)) +
                          " is neither a step nor a kerf.Moment");
  }
}

py::object find(Opened& recording, const std::string& condition, const py::object& after,
                const py::object& before) {
  if (!after.is_none() && !before.is_none())
    throw py::value_error("give after or before, not both: one searches forward, the other backward");
  const bool backward = !before.is_none();
  const Position from = backward          ? position_from(before)
                        : after.is_none() ? Position::end_of(0)
                                          : position_from(after);
  const auto found = recording.find(condition, from, backward);
  return found ? moment(*found) : py::none();
}

py::list find_all(Opened& recording, const std::string& condition, std::optional<std::size_t> limit) {
  py::list all;
  auto at = std::optional(Position::end_of(0));
  while (!limit || all.size() < *limit) {
    at = recording.find(condition, *at, false);
    if (!at) break;
    all.append(moment(*at));
  }
  return all;
}

py::array events(Opened& recording, std::optional<std::uint32_t> first, std::optional<std::uint32_t> last) {
  if (!first) return recording.events(1, last.value_or(recording.steps()));
  return recording.events(*first, last.value_or(*first));
}

std::string config_text(const Opened& recording) { return to_string(recording.info().config); }

py::dict info(const Opened& recording) {
  const RecordingInfo& of = recording.info();
  py::dict all;
  all["scene"] = of.scene;
  all["dimension"] = of.dimension;
  all["volume"] = std::string(to_string(of.volume));
  all["config"] = config_dict(of.config);
  all["imported"] = of.imported;
  all["complete"] = of.complete;
  all["seed"] = of.seed;
  return all;
}

std::vector<py::int_> object_names(const Opened& recording) {
  std::vector<py::int_> names;
  std::ranges::transform(recording.info().names.objects(), std::back_inserter(names),
                         [](const GivenId& id) { return py::int_(py::str(to_string(id))); });
  return names;
}

std::vector<std::string> step_names(const Opened& recording) {
  const auto names = recording.info().names.steps();
  return {names.begin(), names.end()};
}

std::unique_ptr<Opened> what_if(Opened& recording, const std::filesystem::path& out, const py::object& config,
                                std::uint32_t first, std::optional<std::uint64_t> refuse,
                                std::optional<std::pair<std::uint64_t, std::size_t>> take, bool overwrite) {
  if (config.is_none() && !refuse && !take)
    throw py::value_error(
        "say what differs: config=, refuse= (an event), or take= (an event and a candidate)");
  recording.what_if({config, first, refuse, take}, out, overwrite);
  return open_recording(out);
}

bool has_moment(const std::filesystem::path& path, const std::string& condition) {
  return open_part(path)->find(condition, Position::end_of(0), false).has_value();
}

std::unique_ptr<Opened> minimize(Opened& recording, const py::object& holds, const std::filesystem::path& out,
                                 bool overwrite) {
  check_recording(out, overwrite, recording.path());
  std::uint32_t last = recording.steps();
  StillHolds still;
  if (py::isinstance<py::str>(holds)) {
    const auto condition = holds.cast<std::string>();
    const auto hit = recording.find(condition, Position::end_of(0), false);
    if (!hit)
      throw py::value_error("holds: '" + condition + "' never holds, so there is nothing to minimise");
    last = hit->step;
    still = [condition](const std::filesystem::path& path) {
      const py::gil_scoped_acquire lock;
      return has_moment(path, condition);
    };
  } else {
    const auto asked = [holds](std::unique_ptr<Opened> run) {
      return static_cast<bool>(py::bool_(holds(std::move(run))));  // as `if` would read it
    };
    still = [asked](const std::filesystem::path& path) {
      const py::gil_scoped_acquire lock;
      return asked(open_part(path));
    };
    if (!asked(open_recording(recording.path())))
      throw py::value_error(
          "holds: the function returns False for the whole recording, so there is nothing to minimise");
  }
  recording.minimize(still, last, out, overwrite);
  return open_recording(out);
}

void bind_why(py::module_& module) {
  py::class_<PairWhy>(module, "PairWhy",
                      "Why two objects are a pair at the end of a step, or why not; str() says it.")
      .def("__reduce__", refuse_pickling("PairWhy", kTakeValues))
      .def_readonly("step", &PairWhy::step)
      .def_readonly("a", &PairWhy::a, "The smaller id.")
      .def_readonly("b", &PairWhy::b)
      .def_readonly("is_pair", &PairWhy::is_pair,
                    "By the definition: the boxes overlap and one of them moves.")
      .def_readonly("reported", &PairWhy::reported,
                    "The tree reported it; it differs from is_pair only by a fault.")
      .def_readonly("undecided", &PairWhy::undecided,
                    "The boxes of an import touch only in the digits that were written.")
      .def_readonly("boxes_overlap", &PairWhy::boxes_overlap)
      .def_readonly("both_fixed", &PairWhy::both_fixed)
      .def_readonly("axis", &PairWhy::axis, "On which the boxes are farthest apart, or overlap least.")
      .def_readonly("margin", &PairWhy::margin,
                    "The separation on this axis, in units of length: positive: the gap; negative: the "
                    "penetration depth. Not the margin of a fat box.")
      .def_readonly("a_box", &PairWhy::a_box, "As it was given: (2, d) float64.")
      .def_readonly("b_box", &PairWhy::b_box)
      .def_readonly("leaf", &PairWhy::leaf, "The node where the two are compared; None: no leaf holds both.")
      .def_readonly("since", &PairWhy::since, "The event after which they shared it.")
      .def_readonly("changes", &PairWhy::changes,
                    "The steps in which they became a pair, ceased to be one, and so on in turn.")
      .def_readonly("text", &PairWhy::text)
      .def("__str__", [](const PairWhy& why) { return why.text; })
      .def("__repr__", [](const PairWhy& why) {
        return "<kerf.PairWhy: " + std::to_string(why.a) + " and " + std::to_string(why.b) + " in step " +
               std::to_string(why.step) + (why.is_pair ? ": a pair>" : ": no pair>");
      });
}

template <class Difference>
std::optional<std::uint32_t> step_of(const std::optional<Difference>& difference) {
  return difference ? std::optional(difference->step) : std::nullopt;
}

void bind_comparison(py::module_& module) {
  using Comparison = RecordingComparison;
  py::class_<Comparison>(
      module, "Comparison",
      "Where two recordings first differ: each member is a step (int) of this one, or None; but same,\n"
      "object_names, one_unfinished, both_unfinished are bool, declared, steps_only_a and the like lists.")
      .def("__reduce__", refuse_pickling("Comparison", kTakeValues))
      .def_property_readonly("same", &Comparison::same,
                             "bool: nothing differs; of two that are unfinished, as far as they go.")
      .def_property_readonly("one_unfinished", &Comparison::one_unfinished,
                             "bool: only one of them was ended in order; then they are not the same.")
      .def_property_readonly("both_unfinished", &Comparison::both_unfinished,
                             "bool: neither was; what came after their last steps is not compared.")
      .def_readonly("requests", &Comparison::requests, "First step with other requests before it.")
      .def_readonly("config", &Comparison::config, "First step with another configuration.")
      .def_readonly("shapes", &Comparison::shapes, "First step in which objects look otherwise.")
      .def_readonly("state", &Comparison::state, "First step with another tree.")
      .def_readonly("pairs", &Comparison::pairs, "First step with another set of pairs.")
      .def_property_readonly(
          "events", [](const Comparison& c) { return step_of(c.events); }, "First step with another event.")
      .def_property_readonly(
          "operators", [](const Comparison& c) { return step_of(c.operators); },
          "First step in which another operator acted or was refused.")
      .def_property_readonly(
          "theirs", [](const Comparison& c) { return step_of(c.theirs); },
          "Of imports: first step in which the other engines reported other pairs.")
      .def_readonly("verdicts", &Comparison::verdicts, "Of imports: first step with another judgement.")
      .def_readonly("structures", &Comparison::structures,
                    "Of imports: first step with another structure of the other engine.")
      .def_readonly("step_names", &Comparison::step_names, "First step of another name.")
      .def_readonly("steps_only_a", &Comparison::steps_only_a, "list of str: steps of this one only.")
      .def_readonly("steps_only_b", &Comparison::steps_only_b, "The same of the other one.")
      .def_readonly("objects_only_a", &Comparison::objects_only_a, "list of str: objects of this one only.")
      .def_readonly("objects_only_b", &Comparison::objects_only_b, "The same of the other one.")
      .def_readonly("object_names", &Comparison::object_names, "bool: names, labels or colours differ.")
      .def_readonly("declared", &Comparison::declared,
                    "list of str: what was declared, rounded or decided otherwise (margin, pairs to be "
                    "ignored, digits, decisions, scene), a line each.")
      .def("__repr__", [](const Comparison& c) {
        return std::string("<kerf.Comparison: ") + (c.same() ? "the same>" : "not the same>");
      });
}

void bind_verdict(py::module_& module) {
  py::class_<Verdict>(module, "Verdict", "What a replay of a recording found.")
      .def("__reduce__", refuse_pickling("Verdict", kTakeValues))
      .def_property_readonly(
          "holds", &Verdict::holds,
          "The replay is the recorded run, the file is as it was written, and its pairs are exact.")
      .def_readonly("steps", &Verdict::steps, "Replayed, up to where it diverges.")
      .def_readonly("events", &Verdict::events)
      .def_readonly("pairs", &Verdict::pairs)
      .def_readonly("judged", &Verdict::judged, "Steps in which brute force was asked.")
      .def_readonly("missed", &Verdict::missed, "Pairs, by the oracle, summed over the steps.")
      .def_readonly("extra", &Verdict::extra)
      .def_readonly("twice", &Verdict::twice)
      .def_readonly("first_wrong_step", &Verdict::first_wrong_step, "Of the pairs; 0: none.")
      .def_property_readonly(
          "changed", [](const Verdict& v) { return v.change ? v.change->what : std::string(); },
          "What was changed after it was recorded; empty: nothing.")
      .def("__bool__", &Verdict::holds)
      .def("__repr__", [](const Verdict& v) {
        return "<kerf.Verdict: " + std::to_string(v.steps) +
               (v.holds() ? " steps hold" : " steps, does not hold") + "; brute force was asked in " +
               (v.judged == 0 ? "none>" : std::to_string(v.judged) + ">");
      });
}

void bind_contents(py::class_<Opened>& type) {
  type.def_property_readonly("path", &Opened::path, "The file.")
      .def_property_readonly("dimension", &Opened::dimension, "2 or 3.")
      .def_property_readonly("steps", &Opened::steps, "How many steps it has; they count from 1.")
      .def_property_readonly("info", &info,
                             "Scene, parameters of the tree, and whether it was ended in order.")
      .def_property_readonly("config_text", &config_text, "The parameters as 'name=value,...'.")
      .def_property_readonly("object_names", &object_names,
                             "What the other engine calls object 0, 1, ...; empty: their own numbers.")
      .def_property_readonly("step_names", &step_names,
                             "What the other engine calls step 1, 2, ...; empty: their own numbers.")
      .def_property_readonly("rows", &Opened::rows,
                             "One row for each step: a structured array with step, objects, changed, pairs, "
                             "events, leaves, height, entries, redundancy, placed, refused, deferred, "
                             "seconds (of the broad phase), first_event, state_hash, pairs_hash.")
      .def("events", &events, py::arg("first") = py::none(), py::arg("last") = py::none(),
           "The events of a step, of the steps first to last, or of all: a structured array.\n\n"
           "kind, op, reason and phase are kerf.EventKind, Operator, Refusal and Phase; -1 (NaN) stands for "
           "what a\n"
           "kind does not have: run.events(7)['kind'] == kerf.EventKind.acted. count is the leaves that hold "
           "a\n"
           "placed object, or how many events were deferred; left and right are those of a partitioner "
           "afterwards.")
      .def("describe", &Opened::describe, py::arg("event"), "An event in words.")
      .def("pairs", &Opened::pairs, py::arg("step"),
           "At the end of a step: (m, 2) uint32, the smaller id first.")
      .def("their_pairs", &Opened::their_pairs, py::arg("step"),
           "Of an import: the pairs that the other engine reported, as it did: (m, 2) uint32.")
      .def("ids", &Opened::ids, py::arg("step"),
           "The objects present at the end of a step, ascending: (n,) uint32.")
      .def("boxes", &Opened::boxes, py::arg("step"),
           "Their boxes, in the order of ids(step): (n, 2, d) float32.")
      .def("fixed", &Opened::fixed, py::arg("step"), "Which of them are fixed: (n,) bool.");
}

void bind_questions(py::class_<Opened>& type) {
  type.def(
          "find", &find, py::arg("condition"), py::kw_only(), py::arg("after") = py::none(),
          py::arg("before") = py::none(),
          "The first moment after one (the beginning), or the last before one, at which a condition holds: "
          "a\n"
          "kerf.Moment (step, event), or None. Its event is None at the end of a step. after and before are\n"
          "moments or steps. Conditions are those of the debugger: docs/DEBUGGING.md. Raises ValueError\n"
          "for a wrong one.")
      .def("find_all", &find_all, py::arg("condition"), py::kw_only(), py::arg("limit") = py::none(),
           "All moments at which a condition holds, or the first `limit`: a list of kerf.Moment. Raises "
           "ValueError\n"
           "for a wrong condition.")
      .def("values", &Opened::values, py::arg("expression"),
           "An expression such as 'pairs/objects' at the end of each step: (steps,) float64, NaN where it "
           "has none.\n"
           "Raises ValueError for a wrong expression, and for one about single events.")
      .def("why", &Opened::why, py::arg("a"), py::arg("b"), py::arg("step"),
           "Why two objects are a pair at the end of a step, or why not: a kerf.PairWhy.")
      .def("why_event", &Opened::why_event, py::arg("event"), "Why an event happened, in sentences.")
      .def("why_node", &Opened::why_node, py::arg("node"), py::arg("step"),
           "A node at the end of a step, and what the criteria say of it, in sentences.")
      .def("what_if", &what_if, py::arg("out"), py::kw_only(), py::arg("config") = py::none(),
           py::arg("first") = 1, py::arg("refuse") = py::none(), py::arg("take") = py::none(),
           py::arg("overwrite") = false,
           "Runs the same boxes again with a difference, and records that: a kerf.Recording of the file "
           "`out`.\n\n"
           "config   parameters that differ, from step `first` on\n"
           "refuse   an event: its operator does not act\n"
           "take     (event, candidate): its split divides by that candidate of its ballot")
      .def("compare", &Opened::compare, py::arg("other"), "Where this and another recording first differ.")
      .def("minimise", &minimize, py::arg("holds"), py::arg("out"), py::kw_only(),
           py::arg("overwrite") = false,
           "The smallest run that still shows something, recorded into the file `out`: a kerf.Recording.\n\n"
           "holds   a condition, or a function that takes a kerf.Recording and returns bool. Objects, steps "
           "and\n"
           "        operators are left out as long as it holds (delta debugging).")
      .def(
          "verify",
          [](const Opened& recording, std::uint32_t every) {
            return verify_recording(recording.path(), every);
          },
          py::arg("oracle_every") = 1,
          "Replays all, and compares it with what was recorded and the pairs of every so many steps with "
          "brute\n"
          "force (0: never): a kerf.Verdict, which is true if all is as it should be.");
}

/// What kerf/__init__.py calls the kinds, operators, reasons and phases, for a test of both.
py::dict enum_names() {
  const auto names = [](int count, auto name) {
    py::list all;
    for (int k = 0; k < count; ++k) all.append(std::string(name(k)));
    return all;
  };
  py::dict all;
  all["EventKind"] = names(static_cast<int>(event_kind_names().size()),
                           [](int k) { return event_kind_names()[static_cast<std::size_t>(k)]; });
  all["Operator"] = names(kOperatorCount, [](int k) { return to_string(static_cast<Operator>(k)); });
  all["Refusal"] = names(kRefusalCount, [](int k) { return to_string(static_cast<Refusal>(k)); });
  all["Phase"] = names(kPhaseCount, [](int k) { return to_string(static_cast<Phase>(k)); });
  return all;
}

/// A message may hold a path that is no UTF-8, and reads as Python writes such names.
void register_error(py::module_& module) {
  py::exception<RecordingError> made(module, "RecordingError", PyExc_RuntimeError);
  made.doc() =
      "A file that is no recording, is damaged, cannot be written, or does not have what was asked for.";
  static const py::handle type = made.release();  // Python ends before what is static does
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const RecordingError& error) {
      const auto message = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(error.what()));
      PyErr_SetObject(type.ptr(), message.ptr());
    }
  });
}

}  // namespace

void bind_recording(py::module_& module) {
  register_rows();
  register_error(module);
  module.attr("_names") = enum_names();
  bind_why(module);
  bind_comparison(module);
  bind_verdict(module);
  py::class_<Opened> type(module, "Recording", kRecordingClass);
  type.def(py::init(&open_recording), py::arg("path"))
      .def("__len__", &Opened::steps)
      .def("__repr__",
           [](const Opened& recording) {
             return "<kerf.Recording: " + recording.path().string() + ", " +
                    std::to_string(recording.dimension()) + "D, " + std::to_string(recording.steps()) +
                    " steps>";
           })
      .def("__reduce__", refuse_pickling("Recording", "give its path, which kerf.Recording opens"));
  bind_contents(type);
  bind_questions(type);
}

}  // namespace kerf::python

#include "frames/python/check.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/counted.h"
#include "core/query/delta_debug.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// Part of the boxes given.
struct Part {
  std::vector<std::size_t> steps;
  std::vector<std::int64_t> rows;  ///< those that a step does not have are left out of it
};

/// What the function did with a part.
struct Trial {
  RowFaults faults;
  std::string raised;  ///< empty: it returned pairs
};

/// "IndexError: too few", of whatever `str` makes of it.
std::string text_of(const py::error_already_set& error) {
  std::string type = py::str(error.type().attr("__name__"));
  try {
    const std::string what = py::str(error.value());
    return what.empty() ? type : type + ": " + what;
  } catch (const std::exception&) {
    return type;
  }
}

class Checker {
 public:
  Checker(const py::function& function, const std::vector<py::array>& steps, const CheckOptions& options)
      : function_(function), steps_(steps), options_(options) {}

  std::optional<CheckFailure> run();

 private:
  [[nodiscard]] Part all_until(std::size_t step) const;
  [[nodiscard]] py::array boxes_of(const Part& part, std::size_t step) const;
  RowFaults faults_of(const py::object& callable, const py::array& boxes);
  RowFaults faults_of_last(const Part& part);
  Trial try_on(const Part& part);
  bool fails(const Part& part);
  [[nodiscard]] std::optional<std::pair<std::size_t, RowFaults>> first_failure();
  [[nodiscard]] Part smallest(Part part);
  [[nodiscard]] std::vector<std::string> raised_at(std::size_t size) const;

  const py::function& function_;
  const std::vector<py::array>& steps_;
  const CheckOptions& options_;
  std::size_t calls_ = 0;
  std::vector<std::pair<std::size_t, std::string>>
      raised_;  ///< since the last part that fails, with sizes of parts
};

std::size_t size_of(const Part& part) { return part.rows.size() + part.steps.size(); }

Part Checker::all_until(std::size_t step) const {
  Part part;
  part.steps.push_back(step);
  if (options_.stateful) {
    part.steps.resize(step + 1);
    std::iota(part.steps.begin(), part.steps.end(), std::size_t{0});
  }
  py::ssize_t rows = 0;
  for (const std::size_t k : part.steps) rows = std::max(rows, steps_[k].shape(0));
  part.rows.resize(static_cast<std::size_t>(rows));
  std::iota(part.rows.begin(), part.rows.end(), std::int64_t{0});
  return part;
}

/// A copy, so that no function changes what is given.
py::array Checker::boxes_of(const Part& part, std::size_t step) const {
  const py::array& all = steps_[step];
  const auto end = std::ranges::lower_bound(part.rows, static_cast<std::int64_t>(all.shape(0)));
  const py::array_t<std::int64_t> rows(end - part.rows.begin(), part.rows.data());
  return all.attr("take")(rows, 0);
}

RowFaults Checker::faults_of(const py::object& callable, const py::array& boxes) {
  ++calls_;
  const RowTruth truth = true_pairs(boxes, options_.touching);
  const py::object returned = callable(boxes.attr("copy")());
  const std::vector<RowPair> reported = reported_pairs(returned, kReturned);
  RowFaults faults = judge_rows(reported, truth);
  if (faults.any()) refuse_columns(returned, reported, truth);
  return faults;
}

/// In the last step, of a function that sees all of them; of one that remembers nothing it is the only one.
RowFaults Checker::faults_of_last(const Part& part) {
  const py::object callable = options_.stateful ? function_() : py::object(function_);
  RowFaults faults;
  for (const std::size_t step : part.steps) faults = faults_of(callable, boxes_of(part, step));
  return faults;
}

Trial Checker::try_on(const Part& part) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  try {
    return {faults_of_last(part), ""};
  } catch (const py::value_error& error) {  // it returned no pairs
    return {{}, error.what()};
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) throw;
    return {{}, text_of(error)};
  }
}

bool Checker::fails(const Part& part) {
  const Trial trial = try_on(part);
  if (trial.faults.any()) raised_.clear();
  if (!trial.raised.empty()) raised_.emplace_back(size_of(part), trial.raised);
  return trial.faults.any();
}

std::optional<std::pair<std::size_t, RowFaults>> Checker::first_failure() {
  const py::object callable = options_.stateful ? function_() : py::object(function_);
  for (std::size_t step = 0; step < steps_.size(); ++step) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    RowFaults faults = faults_of(callable, steps_[step]);
    if (faults.any()) return std::pair(step, std::move(faults));
  }
  return std::nullopt;
}

Part Checker::smallest(Part part) {
  for (std::size_t before = SIZE_MAX; size_of(part) < before;) {
    before = size_of(part);
    part.rows = delta_debug(part.rows, [&](const std::vector<std::int64_t>& rows) {
      return fails({part.steps, rows});
    });
    const std::size_t last = part.steps.back();
    part.steps = delta_debug(part.steps, [&](const std::vector<std::size_t>& steps) {
      return !steps.empty() && steps.back() == last && fails({steps, part.rows});
    });
  }
  return part;
}

/// Those of parts of that size; each text once.
std::vector<std::string> Checker::raised_at(std::size_t size) const {
  std::vector<std::string> texts;
  for (const auto& [of, text] : raised_)
    if (of == size && std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
  return texts;
}

std::optional<CheckFailure> Checker::run() {
  auto first = first_failure();
  if (!first) return std::nullopt;
  Part part = all_until(first->first);
  CheckFailure failure;
  failure.step = first->first;
  failure.all = std::move(first->second);
  Trial again = try_on(part);
  if (again.faults.any() && options_.shrink) {
    part = smallest(std::move(part));
    failure.raised = raised_at(size_of(part) - 1);
    again = try_on(part);
  }
  failure.repeats = again.faults.any();
  if (failure.repeats) {
    failure.faults = std::move(again.faults);
  } else {
    part = all_until(failure.step);
    failure.faults = failure.all;
    failure.raised.clear();
    if (!again.raised.empty()) failure.raised.push_back(again.raised);
  }
  failure.steps = part.steps;
  failure.rows = part.rows;
  for (const std::size_t step : part.steps) failure.scene.push_back(boxes_of(part, step));
  failure.calls = calls_;
  return failure;
}

std::string list_text(const std::vector<RowPair>& pairs) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(kMost, pairs.size()); ++k)
    text += (k == 0 ? " (" : ", (") + std::to_string(pairs[k][0]) + ", " + std::to_string(pairs[k][1]) + ")";
  return text + (pairs.size() > kMost ? ", ..." : "");
}

std::string line(const char* name, const std::vector<RowPair>& pairs) {
  return pairs.empty() ? "" : std::string(name) + list_text(pairs) + "\n";
}

}  // namespace

std::string CheckFailure::text() const {
  std::string text = "step " + std::to_string(step) + ": " + counted(all.missed.size(), "pair") +
                     " missed, " + std::to_string(all.invented.size()) + " invented, " +
                     std::to_string(all.doubled.size()) + " doubled\n";
  if (!repeats)
    return text + "the same boxes " +
           (raised.empty() ? "gave the right pairs" : "gave no pairs (" + raised[0] + ")") +
           " when they were tried again: the function is not deterministic\n";
  text += counted(rows.size(), "box shows", "boxes show") + " it in " + counted(steps.size(), "step") +
          "; in rows of these boxes:\n";
  text += line("missed", faults.missed) + line("invented", faults.invented) + line("doubled", faults.doubled);
  for (const py::array& boxes : scene) text += std::string(py::repr(boxes)) + "\n";
  if (!raised.empty()) text += "without one of them, the function returned the right pairs, or none:\n";
  for (const std::string& what : raised) text += "  " + what + "\n";
  return text;
}

std::optional<CheckFailure> check(const py::function& function, const std::vector<py::array>& steps,
                                  const CheckOptions& options) {
  return Checker(function, steps, options).run();
}

}  // namespace kerf::python

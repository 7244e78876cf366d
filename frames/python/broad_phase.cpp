#include "frames/python/broad_phase.h"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/broad_phase/pair_changes.h"
#include "core/trace/statistics.h"
#include "frames/python/arrays.h"
#include "frames/python/id_pool.h"
#include "frames/python/pair_lists.h"
#include "frames/python/queries_of.h"
#include "frames/python/run.h"
#include "frames/python/use_once.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf::python {
namespace {

/// Names and numbers as `kerf render` writes them into a manifest: counts, `redundancy`, how often each
/// operator acted, and the seconds of each phase of the last step.
pybind11::dict statistics_dict(const Statistics& statistics) {
  pybind11::dict operators;
  for (int op = 0; op < kOperatorCount; ++op) {
    const auto name = static_cast<Operator>(op);
    operators[pybind11::str(std::string(to_string(name)))] = statistics.count(name);
  }
  pybind11::dict seconds;
  for (int phase = 0; phase < kPhaseCount; ++phase)
    seconds[pybind11::str(std::string(to_string(static_cast<Phase>(phase))))] =
        statistics.phase_seconds[static_cast<std::size_t>(phase)];
  pybind11::dict all;
  all["objects"] = statistics.objects;
  all["leaves"] = statistics.leaves;
  all["height"] = statistics.height;
  all["entries"] = statistics.entries;
  all["redundancy"] = statistics.redundancy;
  all["operators"] = operators;
  all["refused"] = statistics.refused;
  all["deferred"] = statistics.deferred;
  all["placed"] = statistics.placed;
  all["phase_seconds"] = seconds;
  return all;
}

namespace py = pybind11;

/// Whatever core refuses has been refused before, but for numbers that are far too high.
void check_dense(std::span<const ObjectId> ids, std::size_t present) {
  const std::size_t limit = kFreeIds + 4 * present;
  const auto sparse = std::ranges::find_if(ids, [&](ObjectId id) { return id.index() >= limit; });
  if (sparse == ids.end()) return;
  throw py::value_error("ids: row " + std::to_string(sparse - ids.begin()) + " is " +
                        std::to_string(sparse->value) +
                        ", but memory grows with the highest id, so ids below " + std::to_string(limit) +
                        " are taken; number the objects anew, or leave ids out");
}

/// False if Python takes warnings for errors, and this one is raised.
bool warn(const std::string& what) {
  return what.empty() || PyErr_WarnEx(PyExc_RuntimeWarning, what.c_str(), 1) == 0;
}

[[noreturn]] void fail_at(std::size_t row, ObjectId id, const char* problem) {
  throw py::value_error("ids: row " + std::to_string(row) + " is " + std::to_string(id.value) + ", " +
                        problem);
}

/// Throws ValueError for an id that comes twice.
void check_once(std::span<const ObjectId> ids) {
  std::vector<std::pair<ObjectId, std::size_t>> sorted;
  for (std::size_t row = 0; row < ids.size(); ++row) sorted.emplace_back(ids[row], row);
  std::ranges::sort(sorted);
  const auto twice =
      std::ranges::adjacent_find(sorted, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != sorted.end()) fail_at((twice + 1)->second, twice->first, "which an earlier row is, too");
}

/// `kerf.BroadPhase` of one dimension.
template <int D>
class BroadPhaseOf final : public PythonBroadPhase {
 public:
  explicit BroadPhaseOf(const BroadPhaseOptions& options)
      : config_(options.config),
        run_(options.config, options.record, options.overwrite),
        threads_(options.threads) {
    run_.set_threads(options.threads);
    if (options.changes) changes_.emplace();
  }

  ~BroadPhaseOf() override {
    pairs_ = py::object();
    lists_.let_go([this](PairBuffer& memory) { run_.exchange_pairs(memory); });
    if (!warn(run_.left_out())) PyErr_WriteUnraisable(nullptr);
  }

  BroadPhaseOf(const BroadPhaseOf&) = delete;
  BroadPhaseOf& operator=(const BroadPhaseOf&) = delete;

  [[nodiscard]] int dimension() const override { return D; }
  py::array insert(const py::handle& boxes, const py::handle& ids, const py::handle& fixed) override {
    const UseOnce use(in_use_);
    const BoxRows<D> rows(boxes, "boxes");
    const std::vector<std::uint8_t> is_fixed = flag_rows(fixed, rows.size(), "fixed");
    const std::vector<ObjectId> inserted = new_ids(ids, rows.size());
    run_.change(rows.size(), [&](BroadPhase<D>& broad_phase) {
      for (std::size_t row = 0; row < rows.size(); ++row)
        (void)broad_phase.insert(inserted[row], rows.all()[row],
                                 is_fixed[row] != 0 ? Mobility::fixed : Mobility::moving);
      ids_.add(inserted);
    });
    moved_ = true;
    return id_array(inserted);
  }

  void move(const py::handle& boxes, const py::handle& ids) override {
    const UseOnce use(in_use_);
    const BoxRows<D> rows(boxes, "boxes", &rounded_);
    moved_ = true;
    const auto move_all = [&](std::span<const ObjectId> moved) {
      run_.change(moved.size(),
                  [&](BroadPhase<D>& broad_phase) { (void)broad_phase.move_many(moved, rows.all()); });
    };
    if (!ids.is_none()) return move_all(present_ids(ids, rows.size()));
    if (rows.size() != ids_.size())
      throw py::value_error("boxes: there are " + std::to_string(rows.size()) + " rows for " +
                            std::to_string(ids_.size()) +
                            " objects; give a row for each, in the order of .ids, or say which ones by ids=");
    move_all(ids_.all());
  }

  void remove(const py::handle& ids) override {
    const UseOnce use(in_use_);
    const IdRows rows(ids, "ids");
    const std::vector<ObjectId> removed = present_ids(ids, rows.size());
    check_once(removed);
    run_.change(removed.size(), [&](BroadPhase<D>& broad_phase) {
      for (const ObjectId id : removed) (void)broad_phase.remove(id);
      ids_.remove(removed);
    });
    moved_ = true;
  }

  py::array step(const py::handle& boxes) override {
    if (!boxes.is_none()) move(boxes, py::none());
    const UseOnce use(in_use_);
    (void)run_.broad_phase();  // may throw, and then the pairs stay
    pairs_ = py::object();
    lists_.let_go([this](PairBuffer& memory) { run_.exchange_pairs(memory); });
    {
      const py::gil_scoped_release others_run;
      run_.step();
      if (changes_) changes_->update(run_.pairs());
    }
    pairs_ = lists_.array(run_.pairs());
    return pairs_;
  }

  [[nodiscard]] py::array pairs() override {
    const UseOnce use(in_use_);
    if (!pairs_) pairs_ = lists_.array(run_.pairs());
    return pairs_;
  }

  [[nodiscard]] py::array begun() const override {
    const UseOnce use(in_use_);
    return pair_array(changes().begun());
  }

  [[nodiscard]] py::array ended() const override {
    const UseOnce use(in_use_);
    return pair_array(changes().ended());
  }

  [[nodiscard]] py::array ids() const override {
    const UseOnce use(in_use_);
    return id_array(ids_.all());
  }

  [[nodiscard]] py::array boxes() const override {
    const UseOnce use(in_use_);
    std::vector<Box<D>> all;
    std::ranges::transform(ids_.all(), std::back_inserter(all),
                           [&](ObjectId id) { return run_.objects().box(id); });
    return box_array<D>(all);
  }

  [[nodiscard]] py::array fixed() const override {
    const UseOnce use(in_use_);
    py::array_t<bool> flags(static_cast<py::ssize_t>(ids_.size()));
    std::ranges::transform(ids_.all(), flags.mutable_data(),
                           [&](ObjectId id) { return run_.objects().is_fixed(id); });
    return flags;
  }

  [[nodiscard]] std::size_t size() const override { return ids_.size(); }
  [[nodiscard]] std::uint32_t steps() const override { return run_.steps(); }
  [[nodiscard]] py::dict statistics() const override {
    const UseOnce use(in_use_);
    return statistics_dict(run_.statistics());
  }

  [[nodiscard]] const Config& config() const override { return config_; }
  [[nodiscard]] py::object ask(const Question& question) override {
    const UseOnce use(in_use_);
    if (!queries_) queries_ = std::make_unique<QueriesOf<D>>(threads_);
    if (moved_) queries_->update(run_.objects());
    moved_ = false;
    return question(*queries_);
  }

  [[nodiscard]] py::array picture(const PictureOptions& options) const override {
    const UseOnce use(in_use_);
    const std::vector<Body<D>> bodies = recorded_bodies(run_.objects());
    FrameInput<D> input;
    input.bodies = bodies;
    input.tree = &run_.tree();
    input.pairs = run_.pairs();
    input.caption.scene = "python";
    input.caption.broad_phase = "kerf";
    input.caption.step = run_.steps();
    input.caption.objects = run_.objects().size();
    input.caption.moving = count_moving(run_.objects());
    input.caption.pairs = run_.pairs().size();
    input.caption.statistics = run_.statistics();
    input.caption.knows_contacts = false;
    return draw(input, options);
  }

  /// The recording is complete before the warning, which may be an error.
  void close() override {
    const UseOnce use(in_use_);
    const std::string left_out = run_.left_out();
    run_.close();
    if (!warn(left_out)) throw py::error_already_set();
  }

 private:
  [[nodiscard]] std::vector<ObjectId> new_ids(const py::handle& given, std::size_t rows) const {
    if (given.is_none()) return ids_.free(rows);
    const IdRows ids(given, "ids");
    if (ids.size() != rows)
      throw py::value_error("ids: there are " + std::to_string(ids.size()) + " for " + std::to_string(rows) +
                            " boxes");
    check_dense(ids.all(), ids_.size());
    for (std::size_t row = 0; row < rows; ++row)
      if (ids_.has(ids.all()[row])) fail_at(row, ids.all()[row], "which is present already: move it instead");
    check_once(ids.all());
    return {ids.all().begin(), ids.all().end()};
  }

  [[nodiscard]] std::vector<ObjectId> present_ids(const py::handle& given, std::size_t rows) const {
    const IdRows ids(given, "ids");
    if (ids.size() != rows)
      throw py::value_error("ids: there are " + std::to_string(ids.size()) + " for " + std::to_string(rows) +
                            " boxes");
    for (std::size_t row = 0; row < rows; ++row)
      if (!ids_.has(ids.all()[row]))
        fail_at(row, ids.all()[row], "but there is no such object: insert it first");
    return {ids.all().begin(), ids.all().end()};
  }

  [[nodiscard]] const PairChanges& changes() const {
    if (!changes_)
      throw std::runtime_error(
          "begun and ended pairs cost time, so they are found only by BroadPhase(..., changes=True)");
    return *changes_;
  }

  Config config_;
  Run<D> run_;
  IdPool ids_;
  std::optional<PairChanges> changes_;  ///< none: they were not asked for
  unsigned threads_;
  std::unique_ptr<QueriesOf<D>> queries_;  ///< null: nothing was asked so far
  bool moved_ = true;                      ///< the queries do not know all boxes
  AppendBuffer<Box<D>> rounded_;           ///< the boxes of a move
  PairLists lists_;
  pybind11::object pairs_;  ///< the latest list, as an array; null until it is asked for
  mutable bool in_use_ = false;
};

}  // namespace

std::unique_ptr<PythonBroadPhase> make_broad_phase(int dimension, const BroadPhaseOptions& options) {
  if (dimension == 2) return std::make_unique<BroadPhaseOf<2>>(options);
  if (dimension == 3) return std::make_unique<BroadPhaseOf<3>>(options);
  throw py::value_error("dimension: it is " + std::to_string(dimension) + ", but must be 2 or 3");
}

}  // namespace kerf::python

#include "tests/hard/report/table.h"

#include <algorithm>
#include <limits>

#include "frames/rivals/rival.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/hard/settings.h"

namespace kerf::test {
namespace {

template <int D>
void add_columns(std::vector<Column>& columns) {
  for (const VolumeKind kind : volume_kinds<D>())
    columns.push_back({D, true, false, std::string(to_string(kind))});
  for (const Rival<D>& rival : rivals<D>())
    columns.push_back({D, false, rival.flat, std::string(rival.name)});
}

/// What a user of a rival would know: where the objects are at the beginning and how large one usually is.
template <int D>
RivalHints<D> hints_for(const Script<D>& script) {
  RivalHints<D> hints;
  hints.bounds = Box<D>::empty();
  std::vector<Scalar> sizes;
  for (const ScriptStep<D>& step : script) {
    for (const Request<D>& request : step.requests) {
      hints.capacity = std::max(hints.capacity, request.object.value + 1);
      if (request.kind != Request<D>::Kind::insert || !is_valid(request.box)) continue;
      hints.bounds = join(hints.bounds, request.box);
      const Vector<D> extent = request.box.extent();
      sizes.push_back(*std::max_element(extent.value.begin(), extent.value.end()));
    }
    if (!sizes.empty()) break;
  }
  if (sizes.empty()) {
    hints.bounds = {};
    return hints;
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  hints.box_size = std::max(*middle, std::numeric_limits<Scalar>::min());
  return hints;
}

/// Plays one case to every column in one dimension.
template <int D>
class CaseRun {
 public:
  CaseRun(const HardCase& hard_case, Children& children)
      : case_(hard_case),
        children_(children),
        small_(make_script<D>(hard_case, Size::test)),
        large_(make_script<D>(hard_case, Size::report)),
        truth_(find_truth(large_, VolumeKind::box, Feed::boxes)) {}

  void ours(VolumeKind kind, TableCell& cell) {
    const bool box = kind == VolumeKind::box;
    for (Setting setting : settings_for(case_, kind)) {
      if (box && large_.front().requests.size() > kManyObjects) setting.validate_every = 5;
      const std::size_t index = cell.attempts.size();
      cell.attempts.push_back({std::string(setting.config), setting.feed == Feed::posed, {}});
      const auto work = [=, this](Trial& trial) {
        if (box) {
          play_kerf(large_, truth_, setting, trial);
        } else {
          play_kerf(small_, find_truth(small_, kind, setting.feed), setting, trial);
        }
      };
      children_.run(work, setting.flush_to_zero, [&cell, index](const Outcome& outcome) {
        cell.attempts[index].outcome = outcome;
        cell.worst = worse(cell.worst, outcome);
      });
    }
  }

  void rival(const Rival<D>& rival, TableCell& cell) {
    if (case_.ours_only) return;
    const auto work = [&rival, this](Trial& trial) {
      const FlushToZero flush(case_.flush_to_zero);
      const auto subject = rival.make(hints_for(large_), Intake::raw);
      play<D>(large_, truth_, *subject, trial);
    };
    children_.run(work, case_.flush_to_zero, [&cell](const Outcome& outcome) {
      cell.attempts = {{"", false, outcome}};
      cell.worst = outcome;
    });
  }

 private:
  static constexpr std::size_t kManyObjects = 5000;

  const HardCase& case_;
  Children& children_;
  Script<D> small_;
  Script<D> large_;
  Truth truth_;
};

/// Where a rival's cell of the plane is among all columns; none if it only knows space.
const TableCell* cell_in_2d(const Row& row, std::string_view name) {
  std::size_t column = volume_kinds<2>().size();
  for (const Rival<2>& rival : rivals<2>()) {
    if (rival.name == name) return &row.cells[column];
    ++column;
  }
  return nullptr;
}

/// Fills the cells of a row. A column that times out in 2D is not tried in 3D: time-outs take most of the
/// time.
void fill(Row& row, Children& children) {
  CaseRun<2> plane(*row.hard_case, children);
  CaseRun<3> space(*row.hard_case, children);
  const std::size_t first_rival_2d = volume_kinds<2>().size();
  const std::size_t first_3d = first_rival_2d + rivals<2>().size();
  for (std::size_t i = 0; i < rivals<2>().size(); ++i)
    plane.rival(rivals<2>()[i], row.cells[first_rival_2d + i]);
  for (std::size_t i = 0; i < first_rival_2d; ++i) plane.ours(volume_kinds<2>()[i], row.cells[i]);
  std::size_t column = first_3d;
  for (const VolumeKind kind : volume_kinds<3>()) space.ours(kind, row.cells[column++]);
  children.finish();
  for (const Rival<3>& rival : rivals<3>()) {
    const TableCell* easier = cell_in_2d(row, rival.name);
    if (easier != nullptr && easier->worst.verdict == Verdict::time_out) {
      row.cells[column].worst = {Verdict::time_out, {}, "not tried: it timed out in 2D", true};
    } else {
      space.rival(rival, row.cells[column]);
    }
    ++column;
  }
}

}  // namespace

std::vector<Column> all_columns() {
  std::vector<Column> columns;
  add_columns<2>(columns);
  add_columns<3>(columns);
  return columns;
}

Table make_table(std::string_view only, const Limits& limits, unsigned at_once,
                 const std::function<void(const HardCase&)>& progress) {
  Table table;
  table.columns = all_columns();
  table.rows.reserve(hard_cases().size());  // children that end later know their cells by reference
  Children children(limits, at_once);
  for (const HardCase& hard_case : hard_cases()) {
    const std::string name = std::string(hard_case.id) + "_" + std::string(hard_case.name);
    if (name.find(only) == std::string::npos) continue;
    progress(hard_case);
    table.rows.push_back({&hard_case, std::vector<TableCell>(table.columns.size())});
    fill(table.rows.back(), children);
  }
  children.finish();
  return table;
}

}  // namespace kerf::test

#include "frames/python/world.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/float_mode.h"
#include "core/world/world.h"
#include "core/world/world_boxes.h"
#include "frames/python/arrays.h"
#include "frames/python/use_once.h"
#include "frames/python/world_columns.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// What was checked before cannot fail but for what no check sees.
void check_status(WorldStatus status) {
  if (is_failure(status)) throw std::runtime_error(std::string(to_string(status)));
}

py::array handle_array(std::span<const Handle> handles) {
  static_assert(sizeof(Handle) == sizeof(std::uint64_t));
  py::array_t<std::uint64_t> array(static_cast<py::ssize_t>(handles.size()));
  std::memcpy(array.mutable_data(), handles.data(), handles.size_bytes());
  return array;
}

py::array world_pair_array(std::span<const WorldPair> pairs) {
  py::array_t<std::uint64_t> array({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::uint64_t* to = array.mutable_data();
  for (const WorldPair& pair : pairs) {
    *to++ = pair.a.value;
    *to++ = pair.b.value;
  }
  return read_only(std::move(array));
}

[[noreturn]] void fail_at(std::size_t row, const std::string& problem) {
  throw py::value_error("handles: row " + std::to_string(row) + " " + problem);
}

void check_once(std::span<const Handle> handles) {
  std::vector<std::pair<Handle, std::size_t>> sorted;
  for (std::size_t row = 0; row < handles.size(); ++row) sorted.emplace_back(handles[row], row);
  std::ranges::sort(sorted);
  const auto twice =
      std::ranges::adjacent_find(sorted, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != sorted.end()) fail_at((twice + 1)->second, "is in an earlier row, too");
}

/// `kerf.World` of one dimension.
template <int D>
class WorldOf final : public PythonWorld {
 public:
  explicit WorldOf(const WorldOptions& options) : world_(options) {}

  [[nodiscard]] int dimension() const override { return D; }
  py::array insert(const py::handle& boxes, const WorldColumns& columns) override {
    const UseOnce use(in_use_);
    const BoxRows<D> rows(boxes, "boxes");
    std::vector<ObjectDef> defs(rows.size());
    apply_columns(columns, defs);
    std::vector<Handle> handles(rows.size());
    try {
      check_status(world_.insert(rows.all(), defs, handles));
    } catch (...) {
      (void)world_.remove(handles);  // those that found an index
      throw;
    }
    return handle_array(handles);
  }

  void move(const py::handle& handles, const py::handle& boxes) override {
    const UseOnce use(in_use_);
    const BoxRows<D> rows(boxes, "boxes", &rounded_);
    const std::vector<Handle> moved = present(handles);
    if (moved.size() != rows.size())
      throw py::value_error("boxes: there are " + std::to_string(rows.size()) + " for " +
                            std::to_string(moved.size()) + " handles");
    check_status(world_.move(moved, rows.all()));
  }

  void shift_origin(const py::handle& by) override {
    const UseOnce use(in_use_);
    const auto numbers = number_array(by, "by");
    Vector<D> vector;
    if (numbers.ndim() != 1 || numbers.size() != D ||
        !std::all_of(numbers.data(), numbers.data() + numbers.size(),
                     [](double x) { return std::abs(x) <= std::numeric_limits<Scalar>::max(); }))
      throw py::value_error("by: give a finite number for each of the " + std::to_string(D) + " axes");
    std::transform(numbers.data(), numbers.data() + D, vector.value.begin(),
                   [](double x) { return static_cast<Scalar>(x); });
    check_range(vector);
    check_status(world_.shift_origin(vector));
  }

  void remove(const py::handle& handles) override {
    const UseOnce use(in_use_);
    const std::vector<Handle> removed = present(handles);
    check_once(removed);
    check_status(world_.remove(removed));
  }

  void set(const py::handle& handles, const WorldColumns& columns) override {
    const UseOnce use(in_use_);
    const std::vector<Handle> changed = present(handles);
    std::vector<ObjectDef> defs;
    std::ranges::transform(changed, std::back_inserter(defs),
                           [&](Handle handle) { return *world_.find(handle); });
    apply_columns(columns, defs);
    for (std::size_t row = 0; row < changed.size(); ++row) {
      const ObjectDef before = *world_.find(changed[row]);
      if (defs[row].kind != before.kind) check_status(world_.set_kind(changed[row], defs[row].kind));
      if (defs[row].filter != before.filter) check_status(world_.set_filter(changed[row], defs[row].filter));
      if (defs[row].margin != before.margin) check_status(world_.set_margin(changed[row], defs[row].margin));
      check_status(world_.set_user_data(changed[row], defs[row].user_data));
    }
  }

  py::array step() override {
    const UseOnce use(in_use_);
    {
      const py::gil_scoped_release others_run;
      world_.step();
    }
    return world_pair_array(world_.pairs());
  }

  [[nodiscard]] py::array pairs() const override {
    const UseOnce use(in_use_);
    return world_pair_array(world_.pairs());
  }

  [[nodiscard]] py::array begun() const override {
    const UseOnce use(in_use_);
    return world_pair_array(world_.begun());
  }

  [[nodiscard]] py::array ended() const override {
    const UseOnce use(in_use_);
    return world_pair_array(world_.ended());
  }

  [[nodiscard]] py::array of_sensor() const override {
    const UseOnce use(in_use_);
    py::array_t<bool> flags(static_cast<py::ssize_t>(world_.pairs().size()));
    std::ranges::transform(world_.pairs(), flags.mutable_data(), &WorldPair::is_sensor);
    return flags;
  }

  [[nodiscard]] py::array handles() const override {
    const UseOnce use(in_use_);
    std::vector<Handle> all;
    world_.for_each([&](Handle handle) { all.push_back(handle); });
    return handle_array(all);
  }

  [[nodiscard]] py::array boxes(const py::handle& handles) const override {
    const UseOnce use(in_use_);
    std::vector<Box<D>> boxes;
    std::ranges::transform(present(handles), std::back_inserter(boxes),
                           [&](Handle handle) { return *world_.box(handle); });
    return box_array<D>(boxes);
  }

  [[nodiscard]] py::array objects(const py::handle& handles) const override {
    const UseOnce use(in_use_);
    const std::vector<Handle> asked = present(handles);
    py::array_t<PythonObject> rows(static_cast<py::ssize_t>(asked.size()));
    std::ranges::transform(asked, rows.mutable_data(),
                           [&](Handle handle) { return to_python(*world_.find(handle)); });
    return rows;
  }

  [[nodiscard]] std::size_t size() const override { return world_.size(); }
  [[nodiscard]] std::size_t bound() const override { return world_.bound(); }
  [[nodiscard]] py::bytes save() const override {
    const UseOnce use(in_use_);
    std::vector<std::uint8_t> bytes;
    check_status(world_.save(bytes));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  void restore(const py::bytes& state) override {
    const UseOnce use(in_use_);
    const std::string_view text(state);
    std::string why;
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    if (is_failure(world_.restore({bytes, text.size()}, &why))) throw py::value_error("state: " + why);
  }

 private:
  /// What would be clamped is refused: boxes that end at the same place would be pairs for ever.
  void check_range(const Vector<D>& by) const {
    const DefaultFloats floats;
    world_.for_each([&](Handle handle) {
      if (!is_valid(shifted(*world_.box(handle), by)))
        throw py::value_error("by: the box of handle " + std::to_string(handle.value) +
                              " would exceed the range of float32; remove that object, or shift by less");
    });
  }

  [[nodiscard]] std::vector<Handle> present(const py::handle& given) const {
    const py::array array = as_array(given, "handles");
    const char kind = array.dtype().kind();
    if (array.size() == 0 && array.ndim() == 1) return {};
    if (array.ndim() != 1 || (kind != 'u' && kind != 'i'))
      throw py::value_error("handles: the shape is " + shape_text(array) + " and the dtype " +
                            std::string(py::str(array.dtype())) +
                            "; give those that insert returned: (n,) uint64");
    const py::array_t<std::uint64_t, kInOrder> numbers(array);
    std::vector<Handle> handles;
    std::transform(numbers.data(), numbers.data() + numbers.size(), std::back_inserter(handles),
                   [](std::uint64_t value) { return Handle{value}; });
    const auto stale =
        std::ranges::find_if_not(handles, [&](Handle handle) { return world_.contains(handle); });
    if (stale != handles.end())
      fail_at(static_cast<std::size_t>(stale - handles.begin()),
              "names no object of this world: it was removed, or the handle is of a world with another tag");
    return handles;
  }

  World<D> world_;
  AppendBuffer<Box<D>> rounded_;  ///< the boxes of a move
  mutable bool in_use_ = false;
};

}  // namespace

std::unique_ptr<PythonWorld> make_world(int dimension, const WorldOptions& options) {
  if (dimension == 2) return std::make_unique<WorldOf<2>>(options);
  if (dimension == 3) return std::make_unique<WorldOf<3>>(options);
  throw py::value_error("dimension: it is " + std::to_string(dimension) + ", but must be 2 or 3");
}

void register_world_rows() {
  PYBIND11_NUMPY_DTYPE(PythonObject, kind, category, mask, group, margin, user_data);
}

}  // namespace kerf::python

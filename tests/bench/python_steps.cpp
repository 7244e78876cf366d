#include <pybind11/numpy.h>

#include <cstdint>
#include <ctime>
#include <span>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/kernels/box_rows.h"

namespace {

namespace py = pybind11;
using kerf::Box;

constexpr int kInOrder = py::array::c_style | py::array::forcecast;

/// The steps of a program in C++ over the same boxes: moves, the step, and a look at each pair.
template <int D>
class Steps {
 public:
  explicit Steps(unsigned threads) : bsp_(kerf::tuned_config()) { bsp_.set_threads(threads); }

  void insert(const py::array_t<float, kInOrder>& boxes) {
    const std::span<const Box<D>> rows = rows_of(boxes);
    ids_.resize(rows.size());
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
      ids_[row] = {row};
      (void)bsp_.insert(ids_[row], rows[row], kerf::Mobility::moving);
    }
    bsp_.step();
  }

  /// Nanoseconds of a step with boxes in floats.
  std::int64_t step(const py::array_t<float, kInOrder>& boxes) {
    const std::span<const Box<D>> rows = rows_of(boxes);
    return timed([&] { (void)bsp_.move_many(ids_, rows); });
  }

  /// The same with boxes in doubles, which have to be rounded first, as fast as the module does it.
  std::int64_t step_of_doubles(const py::array_t<double, kInOrder>& boxes) {
    return timed([&] {
      rounded_.resize(ids_.size());
      (void)kerf::round_boxes<D>(boxes.data(), ids_.size(), rounded_.data());
      (void)bsp_.move_many(ids_, rounded_);
    });
  }

  [[nodiscard]] std::size_t pairs() const { return bsp_.pairs().size(); }

 private:
  static std::span<const Box<D>> rows_of(const py::array_t<float, kInOrder>& boxes) {
    return {reinterpret_cast<const Box<D>*>(boxes.data()), static_cast<std::size_t>(boxes.shape(0))};
  }

  /// As Python's time.perf_counter_ns().
  static std::int64_t now() {
    timespec time{};
    (void)clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec;
  }

  template <class Move>
  std::int64_t timed(Move move) {
    const std::int64_t start = now();
    move();
    bsp_.step();
    return now() - start;
  }

  kerf::Bsp<D> bsp_;
  std::vector<kerf::ObjectId> ids_;
  std::vector<Box<D>> rounded_;
};

template <int D>
void bind(py::module_& module, const char* name) {
  py::class_<Steps<D>>(module, name)
      .def(py::init<unsigned>(), py::arg("threads"))
      .def("insert", &Steps<D>::insert)
      .def("step", &Steps<D>::step)
      .def("step_of_doubles", &Steps<D>::step_of_doubles)
      .def("pairs", &Steps<D>::pairs);
}

}  // namespace

PYBIND11_MODULE(kerf_steps, module) {
  bind<2>(module, "Steps2D");
  bind<3>(module, "Steps3D");
}

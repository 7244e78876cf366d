#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/world/world.h"
#include "frames/python/world.h"

namespace kerf::python {

/// `kerf.World` of one dimension.
template <int D>
class WorldOf final : public PythonWorld {
 public:
  explicit WorldOf(const WorldOptions& options) : world_(options) {}

  [[nodiscard]] int dimension() const override { return D; }
  pybind11::array insert(const pybind11::handle& boxes, const WorldColumns& columns) override;
  void move(const pybind11::handle& handles, const pybind11::handle& boxes) override;
  void shift_origin(const pybind11::handle& by) override;
  void remove(const pybind11::handle& handles) override;
  void set(const pybind11::handle& handles, const WorldColumns& columns) override;
  pybind11::array step() override;

  [[nodiscard]] pybind11::array pairs() const override;
  [[nodiscard]] pybind11::array begun() const override;
  [[nodiscard]] pybind11::array ended() const override;
  [[nodiscard]] pybind11::array of_sensor() const override;
  [[nodiscard]] pybind11::array handles() const override;
  [[nodiscard]] pybind11::array boxes(const pybind11::handle& handles) const override;
  [[nodiscard]] pybind11::array objects(const pybind11::handle& handles) const override;
  [[nodiscard]] std::size_t size() const override { return world_.size(); }
  [[nodiscard]] std::size_t bound() const override { return world_.bound(); }
  [[nodiscard]] pybind11::bytes save() const override;
  void restore(const pybind11::bytes& state) override;

 private:
  [[nodiscard]] std::vector<Handle> present(const pybind11::handle& given) const;

  World<D> world_;
  AppendBuffer<Box<D>> rounded_;  ///< the boxes of a move
  mutable bool in_use_ = false;
};

}  // namespace kerf::python

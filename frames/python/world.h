#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>

#include "core/world/world.h"
#include "frames/python/made.h"

namespace kerf::python {

/// What objects are beside their boxes, as Python gave it: each a value for all rows, or one a row. None: the
/// default of a new object, or no change of one that is there.
struct WorldColumns {
  pybind11::object kind;
  pybind11::object category;
  pybind11::object mask;
  pybind11::object group;
  pybind11::object margin;
  pybind11::object user_data;
};

/// `kerf.World`, of either dimension. What is wrong with arguments is a ValueError that names the row, and
/// then nothing has been done.
class PythonWorld {
 public:
  PythonWorld() = default;
  PythonWorld(const PythonWorld&) = delete;
  PythonWorld& operator=(const PythonWorld&) = delete;
  virtual ~PythonWorld() = default;

  [[nodiscard]] virtual int dimension() const = 0;
  virtual pybind11::array insert(const pybind11::handle& boxes, const WorldColumns& columns) = 0;
  virtual void move(const pybind11::handle& handles, const pybind11::handle& boxes) = 0;
  virtual void shift_origin(const pybind11::handle& by) = 0;
  virtual void remove(const pybind11::handle& handles) = 0;
  virtual void set(const pybind11::handle& handles, const WorldColumns& columns) = 0;
  virtual pybind11::array step() = 0;

  [[nodiscard]] virtual pybind11::array pairs() const = 0;
  [[nodiscard]] virtual pybind11::array begun() const = 0;
  [[nodiscard]] virtual pybind11::array ended() const = 0;
  /// Which of the pairs are those of a sensor.
  [[nodiscard]] virtual pybind11::array of_sensor() const = 0;
  [[nodiscard]] virtual pybind11::array handles() const = 0;
  [[nodiscard]] virtual pybind11::array boxes(const pybind11::handle& handles) const = 0;
  /// A structured array: kind, category, mask, group, margin, user_data.
  [[nodiscard]] virtual pybind11::array objects(const pybind11::handle& handles) const = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual std::size_t bound() const = 0;
  [[nodiscard]] virtual pybind11::bytes save() const = 0;
  virtual void restore(const pybind11::bytes& state) = 0;
};

/// Throws ValueError for a dimension other than 2 and 3.
std::unique_ptr<PythonWorld> make_world(int dimension, const WorldOptions& options);

/// Makes the rows of `objects` known to numpy.
void register_world_rows();

}  // namespace kerf::python

KERF_CLASS_OF_PYTHON(kerf::python::PythonWorld);

#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "core/base/config.h"
#include "frames/python/made.h"
#include "frames/python/picture.h"
#include "frames/python/queries.h"

namespace kerf::python {

/// How a broad phase of Python's is made.
struct BroadPhaseOptions {
  Config config;
  unsigned threads = 1;
  bool changes = false;            ///< also finds the pairs that begin and end
  std::filesystem::path record{};  ///< also records the run; empty: does not
  bool overwrite = false;          ///< an earlier recording of that name
};

/// `kerf.BroadPhase`, of either dimension. Arguments come as Python gave them; what is wrong with them is a
/// ValueError, and then nothing has been done. One thread at a time may use it: another one gets a
/// RuntimeError.
class PythonBroadPhase {
 public:
  PythonBroadPhase() = default;
  PythonBroadPhase(const PythonBroadPhase&) = delete;
  PythonBroadPhase& operator=(const PythonBroadPhase&) = delete;
  virtual ~PythonBroadPhase() = default;

  [[nodiscard]] virtual int dimension() const = 0;
  /// Returns the ids, one for each row.
  virtual pybind11::array insert(const pybind11::handle& boxes, const pybind11::handle& ids,
                                 const pybind11::handle& fixed) = 0;
  /// `ids` may be None: the rows are all objects by ascending id.
  virtual void move(const pybind11::handle& boxes, const pybind11::handle& ids) = 0;
  virtual void remove(const pybind11::handle& ids) = 0;
  /// `boxes` may be None; else it moves all objects first. Returns the pairs.
  virtual pybind11::array step(const pybind11::handle& boxes) = 0;

  [[nodiscard]] virtual pybind11::array pairs() = 0;
  [[nodiscard]] virtual pybind11::array begun() const = 0;
  [[nodiscard]] virtual pybind11::array ended() const = 0;
  [[nodiscard]] virtual pybind11::array ids() const = 0;
  [[nodiscard]] virtual pybind11::array boxes() const = 0;
  [[nodiscard]] virtual pybind11::array fixed() const = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual std::uint32_t steps() const = 0;
  [[nodiscard]] virtual pybind11::dict statistics() const = 0;
  [[nodiscard]] virtual const Config& config() const = 0;
  /// Asks queries about the boxes as they are now.
  using Question = std::function<pybind11::object(PythonQueries&)>;
  [[nodiscard]] virtual pybind11::object ask(const Question& question) = 0;
  /// The objects, the tree and the pairs of the last step: (height, width, 3) uint8.
  [[nodiscard]] virtual pybind11::array picture(const PictureOptions& options) const = 0;
  /// Ends the recording, if there is one; afterwards nothing can be asked of a broad phase that recorded.
  virtual void close() = 0;
};

/// Throws ValueError for a dimension other than 2 and 3.
std::unique_ptr<PythonBroadPhase> make_broad_phase(int dimension, const BroadPhaseOptions& options);

}  // namespace kerf::python

KERF_CLASS_OF_PYTHON(kerf::python::PythonBroadPhase);

#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/query/compare.h"
#include "core/replay/position.h"
#include "core/replay/verify.h"
#include "frames/python/made.h"
#include "frames/python/picture.h"

namespace kerf::python {

/// Why two objects are a pair at the end of a step, or why not, in the figures that matter most.
struct PairWhy {
  std::uint32_t step = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool is_pair = false;
  bool reported = false;
  bool undecided = false;
  bool boxes_overlap = false;
  bool both_fixed = false;
  int axis = 0;
  double margin = 0;
  pybind11::array a_box;  ///< (2, D) float64
  pybind11::array b_box;
  std::optional<std::uint32_t> leaf;
  std::optional<std::uint64_t> since;
  std::vector<std::uint32_t> changes;  ///< the steps in which they became or ceased to be a pair, in turn
  std::string text;
};

/// What another run of the same boxes has otherwise.
struct WhatIf {
  pybind11::object config;  ///< as config_from takes it
  std::uint32_t first = 1;  ///< the first step with it
  std::optional<std::uint64_t> refuse;
  std::optional<std::pair<std::uint64_t, std::size_t>> take;
};

class PythonRecording;

/// Whether a run still shows what is looked for: text of a condition, or a function of Python's that takes a
/// recording.
using StillHolds = std::function<bool(const std::filesystem::path&)>;

/// `kerf.Recording`, of either dimension. Steps count from 1. Throws RecordingError for steps and events that
/// it does not have, and for a file that is damaged.
class PythonRecording {
 public:
  PythonRecording() = default;
  PythonRecording(const PythonRecording&) = delete;
  PythonRecording& operator=(const PythonRecording&) = delete;
  virtual ~PythonRecording() = default;

  [[nodiscard]] virtual int dimension() const = 0;
  [[nodiscard]] virtual std::filesystem::path path() const = 0;
  [[nodiscard]] virtual std::uint32_t steps() const = 0;
  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
  [[nodiscard]] virtual pybind11::array rows() const = 0;
  /// Of the steps from `first` to `last`.
  [[nodiscard]] virtual pybind11::array events(std::uint32_t first, std::uint32_t last) = 0;
  [[nodiscard]] virtual pybind11::array pairs(std::uint32_t step) = 0;
  [[nodiscard]] virtual pybind11::array their_pairs(std::uint32_t step) = 0;
  [[nodiscard]] virtual pybind11::array ids(std::uint32_t step) = 0;
  [[nodiscard]] virtual pybind11::array boxes(std::uint32_t step) = 0;
  [[nodiscard]] virtual pybind11::array fixed(std::uint32_t step) = 0;
  [[nodiscard]] virtual std::string describe(std::uint64_t event) = 0;

  [[nodiscard]] virtual std::optional<Position> find(const std::string& condition, const Position& from,
                                                     bool backward) = 0;
  /// At the ends of all steps: float64.
  [[nodiscard]] virtual pybind11::array values(const std::string& expression) = 0;
  [[nodiscard]] virtual PairWhy why(std::uint32_t a, std::uint32_t b, std::uint32_t step) = 0;
  [[nodiscard]] virtual std::string why_event(std::uint64_t event) = 0;
  [[nodiscard]] virtual std::string why_node(std::uint32_t node, std::uint32_t step) = 0;
  virtual void what_if(const WhatIf& change, const std::filesystem::path& out, bool overwrite) = 0;
  virtual void minimize(const StillHolds& holds, std::uint32_t last, const std::filesystem::path& out,
                        bool overwrite) = 0;
  [[nodiscard]] virtual RecordingComparison compare(PythonRecording& other) = 0;
  /// The picture of the end of a step, or right after an event of it.
  [[nodiscard]] virtual pybind11::array picture(const Position& at, const PictureOptions& options) = 0;
  /// Where the event is. Throws RecordingError if it is beyond the end.
  [[nodiscard]] virtual Position position_of(std::uint64_t event) const = 0;
};

/// Opens a recording. Throws RecordingError.
std::unique_ptr<PythonRecording> open_recording(const std::filesystem::path& path);
/// The same for a part of one: what conditions name need not be in it.
std::unique_ptr<PythonRecording> open_part(const std::filesystem::path& path);

/// Replays a recording and compares it with itself and the oracle.
Verdict verify_recording(const std::filesystem::path& path, std::uint32_t oracle_every);

}  // namespace kerf::python

KERF_CLASS_OF_PYTHON(kerf::python::PairWhy);
KERF_CLASS_OF_PYTHON(kerf::python::PythonRecording);
KERF_CLASS_OF_PYTHON(kerf::RecordingComparison);
KERF_CLASS_OF_PYTHON(kerf::Verdict);

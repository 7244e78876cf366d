#include "frames/python/statistics.h"

#include <string>

namespace kerf::python {

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

}  // namespace kerf::python

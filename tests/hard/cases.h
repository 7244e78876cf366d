#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/trace/event.h"
#include "tests/hard/script.h"

namespace kerf::test {

/// How large a case is made.
enum class Size : std::uint8_t {
  test,    ///< milliseconds: the default tests
  report,  ///< as large as the list of hard cases says: the table beside the rivals
};

/// A case of the list that is a matter of boxes and requests. Those about directions, kernels, builds and
/// files are tests of their own.
struct HardCase {
  std::string_view id;    ///< "V4", as in the list
  std::string_view name;  ///< "PointsAndFlatPlates"
  std::string_view what;  ///< one line for reports
  Script<2> (*make_2d)(Size) = nullptr;
  Script<3> (*make_3d)(Size) = nullptr;
  /// A configuration of ours that the case needs beside the usual ones; its changes come on top of the
  /// paper's.
  std::string_view config = {};
  /// An operator that must act with that configuration, or the case does not show what it says.
  std::optional<Operator> operates = std::nullopt;
  /// It is about our operators or parameters: other broad phases have nothing to show in it.
  bool ours_only = false;
  /// Played while the processor takes denormals for zero: no pair may be missed, others may be reported.
  bool flush_to_zero = false;
};

/// All cases in the order of the list.
std::span<const HardCase> hard_cases();

template <int D>
Script<D> make_script(const HardCase& hard_case, Size size) {
  if constexpr (D == 2) {
    return hard_case.make_2d(size);
  } else {
    return hard_case.make_3d(size);
  }
}

}  // namespace kerf::test

#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"

namespace kerf::python {

/// Whether boxes that touch and do not overlap further are a pair.
enum class Touching : std::uint8_t {
  pair,    ///< they are: boxes are closed, the rule of Kerf
  none,    ///< they are not: boxes are open
  either,  ///< both answers are right
};

/// Two rows as a function of Python's reported them; they may be none that exist.
using RowPair = std::array<std::int64_t, 2>;

/// What is wrong with reported pairs; each list is sorted.
struct RowFaults {
  std::vector<RowPair> missed;
  std::vector<RowPair> invented;  ///< rows that do not exist, and rows with themselves, among them
  std::vector<RowPair> doubled;   ///< once for each further time
  [[nodiscard]] bool any() const { return !missed.empty() || !invented.empty() || !doubled.empty(); }
};

/// The right answer for an array of boxes.
struct RowTruth {
  std::size_t rows = 0;
  std::vector<Pair> required;  ///< sorted
  std::vector<Pair> allowed;   ///< sorted; the required ones among them
};

/// By brute force, in the precision of the array: (n, 2, d) float32 or float64 in C order, without NaN.
RowTruth true_pairs(const pybind11::array& boxes, Touching touching);

/// The order of pairs, and of the two rows of one, does not matter.
RowFaults judge_rows(const std::vector<RowPair>& reported, const RowTruth& truth);

/// Of pairs that are wrong: throws ValueError if they are two rows of two, no tuples, whose columns are the
/// right pairs. Where there are more pairs or fewer, the shape says that columns were returned.
void refuse_columns(const pybind11::object& returned, const std::vector<RowPair>& reported,
                    const RowTruth& truth);

/// How messages call pairs, and how a sentence about them begins.
struct PairWords {
  const char* name;
  const char* opening;
};
inline constexpr PairWords kReturned{"what the function returned", "the function returned"};
inline constexpr PairWords kGiven{"pairs", "pairs: this is"};

/// Pairs from Python: an (m, 2) array of whole numbers, or any iterable of two each. Throws ValueError for
/// anything else, among it a tuple of arrays and what has a mask.
std::vector<RowPair> reported_pairs(const pybind11::object& given, const PairWords& words);

}  // namespace kerf::python

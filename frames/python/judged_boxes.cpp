#include "frames/python/judged_boxes.h"

#include <algorithm>
#include <iterator>

#include "core/base/float_mode.h"
#include "core/broad_phase/all_pairs.h"
#include "core/replay/oracle.h"
#include "frames/python/arrays.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

enum class Relation : std::uint8_t { apart, touching, overlapping };

/// Of two boxes, each 2 x `dimension` numbers.
template <class Number>
Relation relation(const Number* a, const Number* b, std::size_t dimension) {
  bool closed = true;
  bool open = true;
  for (std::size_t i = 0; i < dimension; ++i) {
    closed &= a[i] <= b[dimension + i] && b[i] <= a[dimension + i];
    open &= a[i] < b[dimension + i] && b[i] < a[dimension + i];
  }
  return open ? Relation::overlapping : closed ? Relation::touching : Relation::apart;
}

/// All pairs that overlap, and maybe some more: float64 is rounded outward.
template <int D>
std::vector<Pair> candidates(const py::array& boxes) {
  const BoxRows<D> rows(boxes, "boxes");
  const py::gil_scoped_release others_run;
  AllPairs<D> oracle;
  for (std::uint32_t row = 0; row < rows.size(); ++row)
    (void)oracle.insert({row}, rows.all()[row], Mobility::moving);
  oracle.step();
  std::vector<Pair> pairs;
  std::ranges::transform(oracle.pairs(), std::back_inserter(pairs),
                         [](const Pair& pair) { return make_pair(pair.a, pair.b); });
  std::ranges::sort(pairs);
  return pairs;
}

template <class Number>
void sort_out(const std::vector<Pair>& pairs, const Number* boxes, std::size_t dimension, Touching touching,
              RowTruth& truth) {
  for (const Pair& pair : pairs) {
    const Number* const a = boxes + pair.a.index() * 2 * dimension;
    const Relation found = relation(a, boxes + pair.b.index() * 2 * dimension, dimension);
    const bool overlap = found == Relation::overlapping;
    const bool touch = found == Relation::touching;
    if (overlap || (touch && touching == Touching::pair)) truth.required.push_back(pair);
    if (overlap || (touch && touching != Touching::none)) truth.allowed.push_back(pair);
  }
}

bool is_of(const RowPair& pair, std::size_t rows) {
  const auto has = [&](std::int64_t row) { return row >= 0 && static_cast<std::uint64_t>(row) < rows; };
  return has(pair[0]) && has(pair[1]) && pair[0] != pair[1];
}

std::vector<RowPair> row_pairs(const std::vector<Pair>& pairs) {
  std::vector<RowPair> rows;
  std::ranges::transform(pairs, std::back_inserter(rows), [](const Pair& pair) {
    return RowPair{pair.a.value, pair.b.value};
  });
  return rows;
}

constexpr const char* kRowsAreMeant =
    "; pairs are rows: np.argwhere(...), or np.stack((i, j), axis=1), instead of np.nonzero(...) or "
    "np.where(...)";

/// Of numpy or of another library.
bool is_array(const py::handle& item) {
  if (!py::hasattr(item, "__array__") || !py::hasattr(item, "ndim")) return false;
  const py::object dimensions = item.attr("ndim");
  return !dimensions.equal(py::int_(0));
}

/// As np.nonzero and np.where return: an array for each axis. Two of two rows each look like two pairs.
bool is_tuple_of_arrays(const py::object& returned) {
  if (!py::isinstance<py::tuple>(returned)) return false;
  const py::tuple items = returned;
  return std::any_of(items.begin(), items.end(), &is_array);
}

/// No pair, in any of the shapes that this has in numpy. An array without rows for each axis is none of them.
bool is_empty(const py::array& array) {
  return array.size() == 0 && (array.ndim() == 1 || array.shape(0) == 0);
}

std::vector<RowPair> pairs_of(const py::array& array, const std::string& opening) {
  const char kind = array.dtype().kind();
  if (is_empty(array)) return {};
  if (array.ndim() == 2 && array.shape(0) == 2 && array.shape(1) != 2)
    throw py::value_error(opening + " an array of shape " + shape_text(array) + kRowsAreMeant);
  if (array.ndim() != 2 || array.shape(1) != 2 || (kind != 'i' && kind != 'u'))
    throw py::value_error(opening + " an array of shape " + shape_text(array) + " and dtype " +
                          std::string(py::str(array.dtype())) +
                          "; pairs are (m, 2) whole numbers: rows of boxes");
  const auto numbers = py::array_t<std::int64_t, kInOrder>(array);
  const bool wrapped = kind == 'u' && std::any_of(numbers.data(), numbers.data() + numbers.size(),
                                                  [](std::int64_t number) { return number < 0; });
  if (wrapped) throw py::value_error(opening + " a whole number beyond 2^63; pairs are rows of boxes");
  std::vector<RowPair> pairs(static_cast<std::size_t>(numbers.shape(0)));
  for (std::size_t k = 0; k < pairs.size(); ++k)
    pairs[k] = {numbers.data()[2 * k], numbers.data()[2 * k + 1]};
  return pairs;
}

}  // namespace

RowTruth true_pairs(const py::array& boxes, Touching touching) {
  const DefaultFloats floats;
  RowTruth truth;
  truth.rows = static_cast<std::size_t>(boxes.shape(0));
  const auto dimension = static_cast<std::size_t>(boxes.shape(2));
  const std::vector<Pair> pairs = dimension == 2 ? candidates<2>(boxes) : candidates<3>(boxes);
  if (boxes.itemsize() == sizeof(float)) {
    sort_out(pairs, static_cast<const float*>(boxes.data()), dimension, touching, truth);
  } else {
    sort_out(pairs, static_cast<const double*>(boxes.data()), dimension, touching, truth);
  }
  return truth;
}

RowFaults judge_rows(const std::vector<RowPair>& reported, const RowTruth& truth) {
  RowFaults faults;
  std::vector<Pair> possible;
  for (const RowPair& pair : reported) {
    if (is_of(pair, truth.rows)) {
      possible.push_back(
          make_pair({static_cast<std::uint32_t>(pair[0])}, {static_cast<std::uint32_t>(pair[1])}));
    } else {
      faults.invented.push_back(pair);
    }
  }
  faults.missed = row_pairs(judge_pairs(possible, truth.required).missed);
  const PairJudgement judged = judge_pairs(possible, truth.allowed);
  std::ranges::copy(row_pairs(judged.extra), std::back_inserter(faults.invented));
  faults.doubled = row_pairs(judged.twice);
  std::ranges::sort(faults.invented);
  return faults;
}

void refuse_columns(const py::object& returned, const std::vector<RowPair>& reported, const RowTruth& truth) {
  if (reported.size() != 2 || !py::isinstance<py::sequence>(returned)) return;
  if (py::isinstance<py::tuple>(returned[py::int_(0)])) return;
  const std::vector<RowPair> turned{{reported[0][0], reported[1][0]}, {reported[0][1], reported[1][1]}};
  if (!judge_rows(turned, truth).any())
    throw py::value_error(
        std::string("the function returned two rows of two, and their columns are the right pairs") +
        kRowsAreMeant);
}

std::vector<RowPair> reported_pairs(const py::object& given, const PairWords& words) {
  const std::string opening = words.opening;
  if (PyObject_CheckBuffer(given.ptr()) != 0) return pairs_of(as_array(given, words.name), opening);
  if (is_tuple_of_arrays(given)) throw py::value_error(opening + " a tuple of arrays" + kRowsAreMeant);
  if (given.is_none() || !py::hasattr(given, "__iter__"))
    throw py::value_error(opening + " " + std::string(py::repr(given)) +
                          "; pairs are (m, 2) whole numbers: rows of boxes");
  const py::list rows(given);
  if (rows.empty()) return {};
  return pairs_of(as_array(rows, words.name), opening);
}

}  // namespace kerf::python

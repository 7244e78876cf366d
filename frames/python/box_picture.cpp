#include "frames/python/box_picture.h"

#include <string>
#include <vector>

#include "core/objects/object_table.h"
#include "frames/python/arrays.h"
#include "frames/python/judged_boxes.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

std::vector<Pair> pairs_of_rows(const py::handle& given, std::size_t rows) {
  std::vector<Pair> pairs;
  if (given.is_none()) return pairs;
  for (const RowPair& pair : reported_pairs(py::reinterpret_borrow<py::object>(given), kGiven)) {
    for (const std::int64_t row : pair)
      if (row < 0 || static_cast<std::uint64_t>(row) >= rows)
        throw py::value_error("pairs: there is no row " + std::to_string(row) + " of " +
                              std::to_string(rows));
    if (pair[0] == pair[1]) throw py::value_error("pairs: row " + std::to_string(pair[0]) + " with itself");
    pairs.push_back(make_pair({static_cast<std::uint32_t>(pair[0])}, {static_cast<std::uint32_t>(pair[1])}));
  }
  return pairs;
}

template <int D>
py::array picture_of(const py::array& boxes, const py::handle& given, const PictureOptions& options) {
  const BoxRows<D> rows(boxes, "source");
  const std::vector<Pair> pairs = pairs_of_rows(given, rows.size());
  ObjectTable<D> objects;
  for (std::uint32_t row = 0; row < rows.size(); ++row)
    (void)objects.insert({row}, rows.all()[row], Mobility::moving);
  const std::vector<Body<D>> bodies = recorded_bodies(objects);
  FrameInput<D> input;
  input.bodies = bodies;
  input.pairs = pairs;
  input.caption.scene = "boxes of an array";
  input.caption.is_run = false;
  input.caption.objects = objects.size();
  input.caption.pairs = pairs.size();
  input.caption.knows_pairs = !given.is_none();
  input.caption.knows_contacts = false;
  return draw(input, options);
}

}  // namespace

py::array box_picture(const py::handle& boxes, const py::handle& pairs, const PictureOptions& options) {
  const py::array array = as_array(boxes, "source");
  const bool is_2d = array.ndim() == 3 && array.shape(2) == 2;
  return is_2d ? picture_of<2>(array, pairs, options) : picture_of<3>(array, pairs, options);
}

}  // namespace kerf::python

#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/objects/object_table.h"
#include "core/spatial/query.h"

namespace kerf::test {

/// Makes queries that meet the boxes of a table where it hurts: at corners, along faces, with directions of
/// zero, with numbers that are as large or small as floats are.
template <int D>
class QueryMaker {
 public:
  QueryMaker(const ObjectTable<D>& table, std::uint64_t seed);

  Vector<D> point();
  Box<D> box();
  Sphere<D> sphere();
  Ray<D> ray();
  Segment<D> segment();
  SweptBox<D> swept();
  Nearest<D> nearest();
  /// Points to planes that are kept until the next call.
  Frustum<D> frustum();

 private:
  Scalar number();
  Scalar near(Scalar x);
  Vector<D> direction();
  Scalar length();
  Box<D> any_box();

  std::vector<Box<D>> boxes_;
  std::vector<Plane<D>> planes_;
  Random random_;
};

}  // namespace kerf::test

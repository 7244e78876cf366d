#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/spatial/query.h"

namespace kerf {

/// A library's structure that answers queries about boxes. Object k is box k. Results are appended in any
/// order. A function returns false if the library has no such query. Where it finds only candidates they are
/// tested here, in floats; its boxes have no margin.
template <int D>
class QueryRival {
 public:
  QueryRival() = default;
  QueryRival(const QueryRival&) = delete;
  QueryRival& operator=(const QueryRival&) = delete;
  virtual ~QueryRival() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  virtual void build(std::span<const Box<D>> boxes) = 0;
  /// As many boxes as before, somewhere else.
  virtual void move(std::span<const Box<D>> boxes) = 0;

  virtual bool overlaps(const Box<D>& /*box*/, std::vector<ObjectId>& /*found*/) { return false; }
  virtual bool overlaps(const Sphere<D>& /*sphere*/, std::vector<ObjectId>& /*found*/) { return false; }
  virtual bool overlaps(const Frustum<D>& /*frustum*/, std::vector<ObjectId>& /*found*/) { return false; }
  /// Of rays of finite length.
  virtual bool hits(const Ray<D>& /*ray*/, std::vector<Hit>& /*found*/) { return false; }
  virtual bool first_hit(const Ray<D>& /*ray*/, Hit& /*first*/) { return false; }
  virtual bool hits(const SweptBox<D>& /*swept*/, std::vector<Hit>& /*found*/) { return false; }
  virtual bool nearest(const Nearest<D>& /*nearest*/, std::vector<Neighbour>& /*found*/) { return false; }
};

/// All libraries that answer queries, and can be trusted with boxes in D dimensions.
template <int D>
std::vector<std::unique_ptr<QueryRival<D>>> query_rivals();

}  // namespace kerf

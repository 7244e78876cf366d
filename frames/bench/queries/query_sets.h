#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/spatial/query.h"
#include "frames/rivals/query_rival.h"

namespace kerf {

/// Queries of every kind, near the objects of a scene.
template <int D>
struct QuerySets {
  /// `count` of each kind.
  QuerySets(std::span<const Box<D>> of, std::size_t count, std::uint64_t seed);

  std::vector<Box<D>> points;
  std::vector<Box<D>> boxes;   ///< twice as wide as a usual object
  std::vector<Box<D>> crowds;  ///< in which there are about a hundred objects
  std::vector<Sphere<D>> spheres;
  std::vector<Ray<D>> rays;      ///< through the whole scene
  std::vector<Ray<D>> segments;  ///< a few objects long
  std::vector<SweptBox<D>> swept;
  std::vector<Nearest<D>> nearest;
  std::vector<Nearest<D>> few_nearest;  ///< eight
  std::vector<Frustum<D>> frustums;     ///< in which there are some hundreds of objects
  std::vector<Plane<D>> planes;         ///< of the frustums
};

/// What one query found.
struct Answer {
  std::vector<ObjectId> objects;
  std::vector<Hit> hits;
  std::vector<Neighbour> neighbours;
  void clear();
  [[nodiscard]] std::size_t size() const { return objects.size() + hits.size() + neighbours.size(); }
};

/// A kind of query.
template <int D>
struct QueryKind {
  std::string_view name;
  /// Asks queries `begin` to `end` and returns how much they found together; none if the structure has no
  /// such query. `answer` is that of the last one.
  bool (*ask)(QueryRival<D>& structure, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
              Answer& answer);
};

template <int D>
std::span<const QueryKind<D>> query_kinds();

/// Whether two structures found the same: the same objects; of a first hit and of neighbours, as far away,
/// apart from the roundings of floats.
bool are_alike(std::string_view kind, Answer& a, Answer& b);

}  // namespace kerf

#include "frames/bench/queries/query_sets.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace kerf {
namespace {

template <int D>
class Maker {
 public:
  Maker(std::span<const Box<D>> boxes, std::uint64_t seed) : boxes_(boxes), random_(seed) {
    for (const Box<D>& box : boxes) {
      bounds_ = join(bounds_, box);
      for (int i = 0; i < D; ++i) size_ += box.extent()[i] / static_cast<Scalar>(D * boxes.size());
    }
  }
  /// The mean extent of an object.
  [[nodiscard]] Scalar size() const { return size_; }
  [[nodiscard]] Scalar across() const { return length(bounds_.extent()); }
  /// In or beside an object.
  Vector<D> place() {
    const Box<D>& box = boxes_[random_.below(static_cast<std::uint32_t>(boxes_.size()))];
    return box.center() + direction() * (size_ * static_cast<Scalar>(random_.unit()));
  }
  Vector<D> direction() {
    for (;;) {
      Vector<D> v;
      for (int i = 0; i < D; ++i) v[i] = static_cast<Scalar>(random_.uniform(-1, 1));
      const Scalar norm = length(v);
      if (norm > 0.1F && norm <= 1) return v * (1 / norm);
    }
  }
  Box<D> box(Scalar half) {
    const Vector<D> center = place();
    Vector<D> reach;
    reach.value.fill(half);
    return {center - reach, center + reach};
  }
  /// The half extent of a box that holds about so many objects if they are spread evenly.
  [[nodiscard]] Scalar half_of_crowd(std::size_t count) const {
    double volume = static_cast<double>(count) / static_cast<double>(boxes_.size());
    for (int i = 0; i < D; ++i) volume *= static_cast<double>(bounds_.extent()[i]);
    return static_cast<Scalar>(std::pow(volume, 1.0 / D) / 2);
  }
  /// A pyramid with its top at a place, cut off at the far end: half as wide as it is long.
  void frustum(Scalar far, std::vector<Plane<D>>& planes) {
    const Vector<D> top = place();
    const Vector<D> ahead = direction();
    planes.push_back({ahead, dot(ahead, top) + far});
    Vector<D> side = direction();
    side = side + ahead * -dot(side, ahead);
    side = side * (1 / length(side));
    add_sides(top, ahead, side, planes);
    if constexpr (D == 3) {
      const Vector<3> up{{ahead[1] * side[2] - ahead[2] * side[1], ahead[2] * side[0] - ahead[0] * side[2],
                          ahead[0] * side[1] - ahead[1] * side[0]}};
      add_sides(top, ahead, up, planes);
    }
  }

 private:
  static void add_sides(const Vector<D>& top, const Vector<D>& ahead, const Vector<D>& side,
                        std::vector<Plane<D>>& planes) {
    for (const Scalar sign : {-1.0F, 1.0F}) {
      const Vector<D> normal = side * (sign * 0.97F) + ahead * -0.2425F;
      planes.push_back({normal, dot(normal, top)});
    }
  }

  std::span<const Box<D>> boxes_;
  Random random_;
  Box<D> bounds_ = Box<D>::empty();
  Scalar size_ = 0;
};

template <int D, auto Member>
bool ask_region(QueryRival<D>& structure, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
                Answer& answer) {
  for (std::size_t k = begin; k < end; ++k) {
    answer.objects.clear();
    if (!structure.overlaps((sets.*Member)[k], answer.objects)) return false;
  }
  return true;
}

template <int D, auto Member>
bool ask_hits(QueryRival<D>& structure, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
              Answer& answer) {
  for (std::size_t k = begin; k < end; ++k) {
    answer.hits.clear();
    if (!structure.hits((sets.*Member)[k], answer.hits)) return false;
  }
  return true;
}

template <int D, auto Member>
bool ask_first(QueryRival<D>& structure, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
               Answer& answer) {
  answer.hits.resize(1);
  for (std::size_t k = begin; k < end; ++k)
    if (!structure.first_hit((sets.*Member)[k], answer.hits.front())) return false;
  if (answer.hits.front().object.is_none()) answer.hits.clear();
  return true;
}

template <int D, auto Member>
bool ask_nearest(QueryRival<D>& structure, const QuerySets<D>& sets, std::size_t begin, std::size_t end,
                 Answer& answer) {
  for (std::size_t k = begin; k < end; ++k) {
    answer.neighbours.clear();
    if (!structure.nearest((sets.*Member)[k], answer.neighbours)) return false;
  }
  return true;
}

template <int D>
constexpr std::array<QueryKind<D>, 11> kKinds{{{"point", ask_region<D, &QuerySets<D>::points>},
                                               {"box", ask_region<D, &QuerySets<D>::boxes>},
                                               {"box-100", ask_region<D, &QuerySets<D>::crowds>},
                                               {"sphere", ask_region<D, &QuerySets<D>::spheres>},
                                               {"first-hit", ask_first<D, &QuerySets<D>::rays>},
                                               {"ray", ask_hits<D, &QuerySets<D>::rays>},
                                               {"segment", ask_hits<D, &QuerySets<D>::segments>},
                                               {"swept-box", ask_hits<D, &QuerySets<D>::swept>},
                                               {"nearest", ask_nearest<D, &QuerySets<D>::nearest>},
                                               {"nearest-8", ask_nearest<D, &QuerySets<D>::few_nearest>},
                                               {"frustum", ask_region<D, &QuerySets<D>::frustums>}}};

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-4 * (1e-2 + std::abs(a) + std::abs(b)); }

}  // namespace

void Answer::clear() {
  objects.clear();
  hits.clear();
  neighbours.clear();
}

template <int D>
QuerySets<D>::QuerySets(std::span<const Box<D>> of, std::size_t count, std::uint64_t seed) {
  Maker<D> maker(of, seed);
  const std::size_t each = D == 2 ? 3 : 5;
  planes.reserve(each * count);
  for (std::size_t k = 0; k < count; ++k) {
    points.push_back(maker.box(0));
    boxes.push_back(maker.box(maker.size()));
    crowds.push_back(maker.box(maker.half_of_crowd(100)));
    spheres.push_back({maker.place(), maker.size()});
    const Vector<D> from = maker.place();
    rays.push_back({from, maker.direction(), maker.across()});
    const Vector<D> start = maker.place();
    segments.push_back({start, maker.direction() * (5 * maker.size()), 1});
    const Box<D> box = maker.box(maker.size() / 2);
    swept.push_back({box, maker.direction() * (5 * maker.size()), 1});
    nearest.push_back({maker.place(), 1});
    few_nearest.push_back({maker.place(), 8});
    maker.frustum(4 * maker.half_of_crowd(100), planes);
    frustums.push_back({std::span(planes).last(each)});
  }
}

template <>
std::span<const QueryKind<2>> query_kinds<2>() {
  return kKinds<2>;
}
template <>
std::span<const QueryKind<3>> query_kinds<3>() {
  return kKinds<3>;
}

bool are_alike(std::string_view kind, Answer& a, Answer& b) {
  if (a.size() != b.size()) return false;
  std::ranges::sort(a.objects);
  std::ranges::sort(b.objects);
  if (a.objects != b.objects) return false;
  const auto near_t = [](const Hit& x, const Hit& y) { return is_near(x.t, y.t); };
  const auto near_d = [](const Neighbour& x, const Neighbour& y) {
    return is_near(x.squared_distance, y.squared_distance);
  };
  std::ranges::sort(a.neighbours, std::less<>());
  std::ranges::sort(b.neighbours, std::less<>());
  if (!std::ranges::equal(a.neighbours, b.neighbours, near_d)) return false;
  if (kind != "first-hit") {
    std::ranges::sort(a.hits, {}, &Hit::object);
    std::ranges::sort(b.hits, {}, &Hit::object);
    if (!std::ranges::equal(a.hits, b.hits, {}, &Hit::object, &Hit::object)) return false;
  }
  return std::ranges::equal(a.hits, b.hits, near_t);
}

template struct QuerySets<2>;
template struct QuerySets<3>;

}  // namespace kerf

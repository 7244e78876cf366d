#pragma once

#include <cstdint>
#include <vector>

#include "core/objects/object_table.h"
#include "core/spatial/spatial_index.h"
#include "core/spatial/touch.h"
#include "frames/rivals/query_rival.h"

namespace kerf {

/// Our index, as it is asked by a program.
template <int D>
class KerfQueries final : public QueryRival<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "kerf"; }
  void build(std::span<const Box<D>> boxes) override {
    table_ = ObjectTable<D>();
    table_.make_room(boxes.size());
    for (std::uint32_t id = 0; id < boxes.size(); ++id)
      (void)table_.insert({id}, boxes[id], Mobility::moving);
    index_.forget();
    index_.update(table_);
  }
  /// As with `Bsp`, the table has the boxes already when the queries come.
  void prepare(std::span<const Box<D>> boxes) {
    for (std::uint32_t id = 0; id < boxes.size(); ++id) (void)table_.move({id}, boxes[id]);
  }
  void move(std::span<const Box<D>> /*boxes*/) override { index_.update(table_); }
  bool overlaps(const Box<D>& box, std::vector<ObjectId>& found) override {
    return index_.overlaps(box, found) == QueryStatus::ok;
  }
  bool overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found) override {
    return index_.overlaps(sphere, found) == QueryStatus::ok;
  }
  bool overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found) override {
    return index_.overlaps(frustum, found) == QueryStatus::ok;
  }
  bool hits(const Ray<D>& ray, std::vector<Hit>& found) override {
    return index_.hits(ray, found) == QueryStatus::ok;
  }
  bool first_hit(const Ray<D>& ray, Hit& first) override {
    return index_.first_hit(ray, first) == QueryStatus::ok;
  }
  bool hits(const SweptBox<D>& swept, std::vector<Hit>& found) override {
    return index_.hits(swept, found) == QueryStatus::ok;
  }
  bool nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found) override {
    return index_.nearest(nearest, found) == QueryStatus::ok;
  }

 private:
  ObjectTable<D> table_;
  SpatialIndex<D> index_;
};

/// The truth: every box is looked at.
template <int D>
class ScanQueries final : public QueryRival<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "scan"; }
  void build(std::span<const Box<D>> boxes) override { boxes_ = boxes; }
  void move(std::span<const Box<D>> boxes) override { boxes_ = boxes; }
  bool overlaps(const Box<D>& box, std::vector<ObjectId>& found) override { return scan(box, found); }
  bool overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found) override {
    return scan(sphere, found);
  }
  bool overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found) override {
    return scan(frustum, found);
  }
  bool hits(const Ray<D>& ray, std::vector<Hit>& found) override { return cast(ray, found); }
  bool hits(const SweptBox<D>& swept, std::vector<Hit>& found) override { return cast(swept, found); }
  bool first_hit(const Ray<D>& ray, Hit& first) override {
    std::vector<Hit> all;
    cast(ray, all);
    first = all.empty() ? Hit{ObjectId::none(), std::numeric_limits<Scalar>::infinity()}
                        : std::ranges::min(all, std::less<>());
    return true;
  }
  bool nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found) override {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id)
      found.push_back({{id}, squared_distance(nearest.point, boxes_[id])});
    std::ranges::sort(found, std::less<>());
    found.resize(std::min(found.size(), nearest.count));
    return true;
  }

 private:
  template <class Region>
  bool scan(const Region& region, std::vector<ObjectId>& found) {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id)
      if (touches(region, boxes_[id])) found.push_back({id});
    return true;
  }
  bool cast(const Cast<D>& cast, std::vector<Hit>& found) {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id)
      if (touches(cast, boxes_[id])) found.push_back({{id}, entry_of(cast, boxes_[id])});
    return true;
  }

  std::span<const Box<D>> boxes_;
};

}  // namespace kerf

#include "tests/support/query_judge.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

#include "core/spatial/batch.h"
#include "core/spatial/touch.h"
#include "tests/support/query_maker.h"

namespace kerf::test {
namespace {

std::string to_text(const ObjectId& object) { return std::to_string(object.value); }
std::string to_text(const Hit& hit) {
  std::ostringstream text;
  text << hit.object.value << "@" << std::hexfloat << hit.t;
  return text.str();
}
std::string to_text(const Neighbour& neighbour) {
  std::ostringstream text;
  text << neighbour.object.value << "@" << std::hexfloat << neighbour.squared_distance;
  return text.str();
}

template <class Item>
std::string difference(const std::string& what, const std::vector<Item>& is, const std::vector<Item>& must) {
  if (is == must) return {};
  const auto at = std::ranges::mismatch(is, must);
  return what + ": finds " + std::to_string(is.size()) + ", must find " + std::to_string(must.size()) +
         "; number " + std::to_string(at.in1 - is.begin()) + " is " +
         (at.in1 == is.end() ? "missing" : to_text(*at.in1)) + ", must be " +
         (at.in2 == must.end() ? "missing" : to_text(*at.in2));
}

template <int D>
class Judge {
 public:
  Judge(const ObjectTable<D>& table, const SpatialIndex<D>& index, TreeWalk<D>* walk)
      : table_(table), index_(index), walk_(walk) {}

  [[nodiscard]] const std::string& verdict() const { return verdict_; }

  template <class Region>
  void region(const std::string& name, const Region& region) {
    std::vector<ObjectId> must;
    if (check(region) == QueryStatus::ok)
      for_each_placed(table_, [&](ObjectId object) {
        if (touches(region, table_.box(object))) must.push_back(object);
      });
    std::vector<ObjectId> is;
    note(name, index_.overlaps(region, is), check(region));
    note(difference(name, is, must));
    visit(name, region, must);
    BatchResult<ObjectId> batch;
    overlaps(index_, std::span<const Region>(&region, 1), pool_, batch);
    note(difference(name + " in a batch", batch.items, must));
    if (walk_ == nullptr) return;
    is.clear();
    note(name, walk_->overlaps(region, is), check(region));
    note(difference(name + " in the tree", is, must));
    note_visits(name, must.size());
  }

  template <class Way>
  void cast(const std::string& name, const Way& way) {
    const Cast<D> cast(way);
    std::vector<Hit> must;
    if (check(cast) == QueryStatus::ok)
      for_each_placed(table_, [&](ObjectId object) {
        if (touches(cast, table_.box(object))) must.push_back({object, entry_of(cast, table_.box(object))});
      });
    std::ranges::sort(must, std::less<>());
    std::vector<Hit> is;
    note(name, index_.hits(way, is), check(cast));
    note(difference(name, is, must));
    std::vector<ObjectId> objects;
    for (const Hit& hit : must) objects.push_back(hit.object);
    visit(name, cast, objects);
    first(name, way, must);
    BatchResult<Hit> batch;
    hits(index_, std::span<const Way>(&way, 1), pool_, batch);
    note(difference(name + " in a batch", batch.items, must));
    if (walk_ == nullptr) return;
    is.clear();
    note(name, walk_->hits(way, is), check(cast));
    note(difference(name + " in the tree", is, must));
    note_visits(name, must.size());
  }

  void nearest(const Nearest<D>& query) {
    std::vector<Neighbour> must;
    if (check(query) == QueryStatus::ok)
      for_each_placed(table_, [&](ObjectId object) {
        const Box<D> box = table_.box(object);
        if (touches(Sphere<D>{query.point, query.max_distance}, box))
          must.push_back({object, squared_distance(query.point, box)});
      });
    std::ranges::sort(must, std::less<>());
    must.resize(std::min(must.size(), query.count));
    std::vector<Neighbour> is;
    note("nearest", index_.nearest(query, is), check(query));
    note(difference("nearest", is, must));
    BatchResult<Neighbour> batch;
    kerf::nearest(index_, std::span<const Nearest<D>>(&query, 1), pool_, batch);
    note(difference("nearest in a batch", batch.items, must));
    if (walk_ == nullptr) return;
    is.clear();
    note("nearest", walk_->nearest(query, is), check(query));
    note(difference("nearest in the tree", is, must));
  }

 private:
  template <class Way>
  void first(const std::string& name, const Way& way, const std::vector<Hit>& must) {
    const Hit none{ObjectId::none(), std::numeric_limits<Scalar>::infinity()};
    const Hit least = must.empty() ? none : must.front();
    Hit is = none;
    (void)index_.first_hit(way, is);
    note(difference<Hit>("first of " + name, {is}, {least}));
    if (walk_ == nullptr) return;
    is = none;
    (void)walk_->first_hit(way, is);
    note(difference<Hit>("first of " + name + " in the tree", {is}, {least}));
  }
  /// All are visited; and no more than wanted.
  template <class Query>
  void visit(const std::string& name, const Query& query, std::vector<ObjectId> must) {
    std::ranges::sort(must);
    std::vector<ObjectId> is;
    auto all = [&](ObjectId object) {
      is.push_back(object);
      return true;
    };
    (void)index_.visit(query, make_visitor(all));
    std::ranges::sort(is);
    note(difference("visit of " + name, is, must));
    std::size_t calls = 0;
    auto one = [&](ObjectId) { return ++calls == 0; };
    (void)index_.visit(query, make_visitor(one));
    if (calls != std::min<std::size_t>(must.size(), 1)) note("visit of " + name + " does not end");
  }
  /// What the leaves have and what waits is all that was found.
  void note_visits(const std::string& name, std::size_t found) {
    std::size_t in_leaves = 0;
    for (const NodeVisit& visit : walk_->visits()) in_leaves += visit.found;
    if (in_leaves > found || in_leaves + walk_->waiting().size() < found)
      note(name + ": leaves found " + std::to_string(in_leaves) + " of " + std::to_string(found));
  }
  void note(const std::string& name, QueryStatus is, QueryStatus must) {
    if (is != must)
      note(name + " is " + std::string(to_string(is)) + ", must be " + std::string(to_string(must)));
  }
  void note(const std::string& text) {
    if (verdict_.empty()) verdict_ = text;
  }

  const ObjectTable<D>& table_;
  const SpatialIndex<D>& index_;
  TreeWalk<D>* walk_;
  TaskPool pool_;
  std::string verdict_;
};

}  // namespace

template <int D>
std::string judge_queries(const ObjectTable<D>& table, const SpatialIndex<D>& index, TreeWalk<D>* walk,
                          std::uint32_t rounds, std::uint64_t seed) {
  QueryMaker<D> maker(table, seed);
  Judge<D> judge(table, index, walk);
  for (std::uint32_t round = 0; round < rounds && judge.verdict().empty(); ++round) {
    const Vector<D> point = maker.point();
    judge.region("point", Box<D>{point, point});
    judge.region("box", maker.box());
    judge.region("sphere", maker.sphere());
    judge.region("frustum", maker.frustum());
    judge.cast("ray", maker.ray());
    judge.cast("segment", maker.segment());
    judge.cast("swept box", maker.swept());
    judge.nearest(maker.nearest());
  }
  return judge.verdict();
}

template std::string judge_queries<2>(const ObjectTable<2>&, const SpatialIndex<2>&, TreeWalk<2>*,
                                      std::uint32_t, std::uint64_t);
template std::string judge_queries<3>(const ObjectTable<3>&, const SpatialIndex<3>&, TreeWalk<3>*,
                                      std::uint32_t, std::uint64_t);

}  // namespace kerf::test

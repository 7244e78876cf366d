#include <CGAL/box_intersection_d.h>

#include "frames/rivals/makers.h"
#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

template <int D>
struct CgalBox {
  Box<D> box;
  ObjectId object;
};

template <int D>
struct CgalTraits {
  using Box_parameter = const CgalBox<D>&;  // NOLINT(readability-identifier-naming): CGAL's name
  using NT = Scalar;
  using ID = std::uint32_t;
  static int dimension() { return D; }
  static ID id(Box_parameter b) { return b.object.value; }
  static NT min_coord(Box_parameter b, int axis) { return b.box.min[axis]; }
  static NT max_coord(Box_parameter b, int axis) { return b.box.max[axis]; }
};

template <int D>
class CgalRival final : public RivalBase<D> {
 public:
  CgalRival(const RivalHints<D>& hints, Intake intake) : RivalBase<D>(hints, intake) {}
  [[nodiscard]] std::string_view name() const override { return "cgal-box-intersection"; }

 private:
  void add(ObjectId object, const Box<D>& /*box*/, bool fixed) override {
    if (place_.size() <= object.index()) place_.resize(object.index() + 1);
    std::vector<ObjectId>& set = fixed ? fixed_ : moving_;
    place_[object.index()] = set.size();
    set.push_back(object);
  }
  void change(ObjectId /*object*/, const Box<D>& /*box*/) override {}
  void drop(ObjectId object) override {
    std::vector<ObjectId>& set = this->is_fixed(object) ? fixed_ : moving_;
    const std::size_t place = place_[object.index()];
    set[place] = set.back();
    place_[set[place].index()] = place;
    set.pop_back();
  }
  void tell_structure(StructureParts<D>& parts) const override {
    parts.unseen = "CGAL builds and drops its segment trees within one call";
  }
  void find_pairs() override {
    constexpr std::ptrdiff_t kCutoff = 10;  // CGAL's default
    constexpr auto kTopology = CGAL::Box_intersection_d::CLOSED;
    const auto keep = [this](const CgalBox<D>& a, const CgalBox<D>& b) { this->report(a.object, b.object); };
    fill(moving_, moving_boxes_);
    CGAL::box_self_intersection_d(moving_boxes_.begin(), moving_boxes_.end(), keep, CgalTraits<D>{}, kCutoff,
                                  kTopology);
    if (fixed_.empty()) return;
    fill(fixed_, fixed_boxes_);
    CGAL::box_intersection_d(moving_boxes_.begin(), moving_boxes_.end(), fixed_boxes_.begin(),
                             fixed_boxes_.end(), keep, CgalTraits<D>{}, kCutoff, kTopology,
                             CGAL::Box_intersection_d::BIPARTITE);
  }
  void fill(const std::vector<ObjectId>& objects, std::vector<CgalBox<D>>& boxes) const {
    boxes.clear();
    for (const ObjectId object : objects) boxes.push_back({this->shown(object), object});
  }

  std::vector<std::size_t> place_;  ///< per object: where it stands in its set
  std::vector<ObjectId> moving_;
  std::vector<ObjectId> fixed_;
  std::vector<CgalBox<D>> moving_boxes_;
  std::vector<CgalBox<D>> fixed_boxes_;
};

}  // namespace

template <int D>
std::unique_ptr<BroadPhase<D>> make_cgal(const RivalHints<D>& hints, Intake intake) {
  return std::make_unique<CgalRival<D>>(hints, intake);
}

template std::unique_ptr<BroadPhase<2>> make_cgal<2>(const RivalHints<2>&, Intake);
template std::unique_ptr<BroadPhase<3>> make_cgal<3>(const RivalHints<3>&, Intake);

}  // namespace kerf

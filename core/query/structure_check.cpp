#include "core/query/structure_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/shortest_text.h"
#include "core/query/structure_measures.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 16> kNames{"child outside its parent",
                                                  "object outside its cell",
                                                  "object in no cell",
                                                  "object in two cells",
                                                  "object not where it reaches",
                                                  "unknown object",
                                                  "leaf without an object",
                                                  "child of two nodes",
                                                  "too deep",
                                                  "too much overlap",
                                                  "no margin",
                                                  "list out of order",
                                                  "object not in the list",
                                                  "pair never tested",
                                                  "node lost",
                                                  "leaf with children"};

/// What the bounds of a box and of its margin may round away together, as a share of a bound.
constexpr double kRounding = 8 * double{std::numeric_limits<Scalar>::epsilon()};

template <int D>
bool begins_before(const Box<D>& inner, const Box<D>& outer, int axis, const BoundTolerance& tolerance) {
  const double by = double{outer.min[axis]} - double{inner.min[axis]};
  return by > 0 && by > tolerance.allowed(double{outer.min[axis]}, double{inner.min[axis]});
}

template <int D>
bool ends_beyond(const Box<D>& inner, const Box<D>& outer, int axis, const BoundTolerance& tolerance) {
  const double by = double{inner.max[axis]} - double{outer.max[axis]};
  return by > 0 && by > tolerance.allowed(double{outer.max[axis]}, double{inner.max[axis]});
}

std::string axis_name(int axis) { return std::string(1, static_cast<char>('x' + axis)); }

/// To the decimal below `unit`.
double rounded(double number, double unit) {
  if (!(unit > 0) || !std::isfinite(unit)) return number;
  const double step = std::pow(10.0, std::floor(std::log10(unit)));
  return std::round(number / step) * step;
}

template <int D>
class Checker {
 public:
  Checker(const StructureParts<D>& parts, std::span<const KnownObject<D>> objects,
          std::span<const Pair> pairs, const StructureLimits& limits, const StructureNames& names)
      : parts_(parts),
        objects_(objects),
        pairs_(pairs),
        limits_(limits),
        names_(names),
        members_(parts.members),
        children_(children_of(parts)) {
    std::ranges::sort(members_);
    for (const KnownObject<D>& known : objects) boxes_.emplace(known.object, known.box);
  }

  std::vector<StructureFault> run() {
    check_links();
    check_cells();
    check_members();
    if (!parts_.cells.empty()) check_objects();
    for (const AxisList& list : parts_.lists) check_list(list);
    check_pairs();
    return std::move(faults_);
  }

 private:
  using Kind = StructureFaultKind;

  void add(Kind kind, std::uint32_t cell, ObjectId object, std::string text) {
    faults_.push_back({kind, cell == kNoPart ? kNoPart : parts_.cells[cell].name, object, std::move(text)});
  }
  [[nodiscard]] std::string name(std::uint32_t cell) const {
    const std::uint32_t name = parts_.cells[cell].name;
    return names_.cell ? names_.cell(name) : "n" + std::to_string(name);
  }
  [[nodiscard]] std::string number_of(ObjectId object) const {
    return names_.object ? names_.object(object) : std::to_string(object.value);
  }
  [[nodiscard]] std::string text_of(ObjectId object) const { return "object " + number_of(object); }
  [[nodiscard]] Scalar margin_of(std::uint32_t cell) const {
    return cell < limits_.margins.size() ? std::max(limits_.margins[cell], limits_.margin) : limits_.margin;
  }

  /// A node that stands there twice has two parents.
  void check_links() {
    std::unordered_map<std::uint32_t, std::uint32_t> first;
    for (std::uint32_t cell = 0; cell < parts_.cells.size(); ++cell) {
      const auto [known, is_new] = first.emplace(parts_.cells[cell].name, cell);
      if (is_new) continue;
      const auto parent_of = [&](std::uint32_t of) {
        const std::uint32_t parent = parts_.cells[of].parent;
        return parent == kNoPart ? std::string("the root's place") : name(parent);
      };
      add(Kind::child_of_two, cell, {},
          name(cell) + " is a child of " + parent_of(known->second) + " and of " + parent_of(cell));
    }
  }

  void check_cells() {
    for (std::uint32_t cell = 0; cell < parts_.cells.size(); ++cell) {
      const StructureCell<D>& shown = parts_.cells[cell];
      if (shown.depth > limits_.depth)
        add(Kind::too_deep, cell, {},
            name(cell) + " lies at depth " + std::to_string(shown.depth) + ", more than " +
                std::to_string(limits_.depth));
      if (shown.parent != kNoPart && shown.cut == kNoPart) check_inside_parent(cell);
      check_overlap(cell);
    }
  }

  void check_inside_parent(std::uint32_t cell) {
    const Box<D>& box = parts_.cells[cell].box;
    const std::uint32_t parent = parts_.cells[cell].parent;
    if (!holds_rounded(parts_.cells[parent].box, box, limits_.tolerance.child))
      add(Kind::child_outside_parent, cell, {},
          name(cell) + " lies outside its parent " + name(parent) + ": " +
              how_outside(box, parts_.cells[parent].box, limits_.tolerance.child));
  }

  void check_overlap(std::uint32_t parent) {
    if (std::isinf(limits_.overlap)) return;
    const auto& children = children_[parent];
    for (std::size_t i = 0; i < children.size(); ++i)
      for (std::size_t k = i + 1; k < children.size(); ++k) {
        const double share = overlap_share(parts_, children[i], children[k]);
        if (share <= limits_.overlap) continue;
        add(Kind::too_much_overlap, parent, {},
            "the children " + name(children[i]) + " and " + name(children[k]) + " of " + name(parent) +
                " share " + shortest_text(static_cast<Scalar>(share)) + " of its box, more than " +
                shortest_text(static_cast<Scalar>(limits_.overlap)));
      }
  }

  [[nodiscard]] bool is_leaf(std::uint32_t cell) const { return children_[cell].empty(); }

  void check_members() {
    std::vector<std::uint8_t> is_used(parts_.cells.size(), 0);
    for (const CellMember& member : members_) {
      is_used[member.cell] = 1;
      const auto known = boxes_.find(member.object);
      if (known == boxes_.end()) {
        add(Kind::unknown_object, member.cell, member.object,
            name(member.cell) + " holds " + text_of(member.object) + ", which is no object");
      } else if (parts_.holding == Holding::inside) {
        check_inside(member, known->second);
      }
    }
    if (parts_.holding != Holding::inside) return;
    for (std::uint32_t cell = 0; cell < parts_.cells.size(); ++cell)
      if (is_leaf(cell) && is_used[cell] == 0)
        add(Kind::leaf_without_object, cell, {}, "the leaf " + name(cell) + " holds no object");
  }

  void check_inside(const CellMember& member, const Box<D>& box) {
    const Box<D>& outer = parts_.cells[member.cell].box;
    if (holds_rounded(outer, box, limits_.tolerance.object)) {
      check_margin(member, box);
    } else {
      add(Kind::object_outside_cell, member.cell, member.object,
          text_of(member.object) + " lies outside its cell " + name(member.cell) + ": " +
              how_outside(box, outer, limits_.tolerance.object));
    }
  }

  /// What was moved within its margin has used some of it up on one side, but not on both. In doubles: floats
  /// do not hold how long an axis without ends is.
  void check_margin(const CellMember& member, const Box<D>& box) {
    const Box<D>& outer = parts_.cells[member.cell].box;
    const BoundTolerance& tolerance = limits_.tolerance.object;
    const double wanted{margin_of(member.cell)};
    for (int axis = 0; axis < D && wanted > 0; ++axis) {
      const double low{outer.min[axis]};
      const double high{outer.max[axis]};
      const double both = high - low - (double{box.max[axis]} - double{box.min[axis]});
      const double of_floats = kRounding * std::max(std::abs(low), std::abs(high));
      const double rounding = of_floats + tolerance.allowed_apart(low, double{box.min[axis]}) +
                              tolerance.allowed_apart(high, double{box.max[axis]});
      if (both >= 2 * wanted - rounding) continue;
      add(Kind::no_margin, member.cell, member.object,
          name(member.cell) + " leaves " + text_of(member.object) + " a margin of " +
              shortest_text(static_cast<Scalar>(rounded(both / 2, of_floats))) + " along " + axis_name(axis) +
              ", less than " + shortest_text(static_cast<Scalar>(wanted)));
      return;
    }
  }

  void check_objects() {
    std::unordered_map<ObjectId, std::uint32_t> places;
    for (const CellMember& member : members_) ++places[member.object];
    for (const KnownObject<D>& known : objects_) {
      const auto place = places.find(known.object);
      if (place == places.end()) {
        add(Kind::object_in_no_cell, kNoPart, known.object, text_of(known.object) + " is in no cell");
      } else if (parts_.holding == Holding::inside && place->second > 1) {
        add(Kind::object_in_two_cells, kNoPart, known.object,
            text_of(known.object) + " is in " + std::to_string(place->second) + " cells");
      } else if (parts_.holding == Holding::reaching) {
        check_reach(known);
      } else if (parts_.holding == Holding::of_its_depth) {
        check_level(known);
      }
    }
  }

  /// In all cells of one depth that its box reaches, and in no other.
  void check_level(const KnownObject<D>& known) {
    const auto first = std::ranges::find(members_, known.object, &CellMember::object);
    const std::uint32_t depth = parts_.cells[first->cell].depth;
    for (std::uint32_t cell = 0; cell < parts_.cells.size(); ++cell) {
      const bool is_in = std::ranges::binary_search(members_, CellMember{cell, known.object});
      const bool belongs = parts_.cells[cell].depth == depth && reaches(known.box, cell);
      if (is_in && !belongs)
        add(Kind::object_outside_cell, cell, known.object,
            text_of(known.object) + " is in the cell " + name(cell) + ", where it does not belong");
      if (belongs && !is_in)
        add(Kind::object_not_where_it_reaches, cell, known.object,
            text_of(known.object) + " reaches the cell " + name(cell) + ", which does not hold it");
    }
  }

  [[nodiscard]] bool reaches(const Box<D>& box, std::uint32_t cell) const {
    const StructureCell<D>& told = parts_.cells[cell];
    bool all = true;
    for (int axis = 0; axis < D; ++axis)
      all &= (box.min[axis] < told.box.max[axis]) & (box.max[axis] >= told.box.min[axis]);
    if (told.cut == kNoPart) return all;
    const Cut<D>& cut = parts_.cuts[told.cut];
    const Sides sides = classify(project(cut.plane.normal, box), cut.plane.offset);
    return all && (cut.right ? sides.right : sides.left);
  }

  void check_reach(const KnownObject<D>& known) {
    std::vector<std::uint32_t> todo;
    for (std::uint32_t cell = 0; cell < parts_.cells.size(); ++cell)
      if (parts_.cells[cell].parent == kNoPart) todo.push_back(cell);
    while (!todo.empty()) {
      const std::uint32_t cell = todo.back();
      todo.pop_back();
      if (!reaches(known.box, cell)) continue;
      todo.insert(todo.end(), children_[cell].begin(), children_[cell].end());
      if (is_leaf(cell) && !std::ranges::binary_search(members_, CellMember{cell, known.object}))
        add(Kind::object_not_where_it_reaches, cell, known.object,
            text_of(known.object) + " reaches the cell " + name(cell) + ", which does not hold it");
    }
  }

  void check_list(const AxisList& list) {
    std::unordered_map<ObjectId, std::uint32_t> ends;
    bool has_upper = false;
    for (std::size_t k = 0; k < list.ends.size(); ++k) {
      const AxisEnd& end = list.ends[k];
      ++ends[end.object];
      has_upper |= end.upper;
      if (!boxes_.contains(end.object))
        add(Kind::unknown_object, kNoPart, end.object,
            "the list along " + axis_name(list.axis) + " holds " + text_of(end.object) +
                ", which is no object");
      if (k > 0 && end.value < list.ends[k - 1].value)
        add(Kind::list_out_of_order, kNoPart, end.object,
            "the list along " + axis_name(list.axis) + " has " + text_of(end.object) + " at " +
                shortest_text(end.value) + " behind " + shortest_text(list.ends[k - 1].value));
    }
    for (const KnownObject<D>& known : objects_)
      if (ends[known.object] != (has_upper ? 2 : 1))
        add(Kind::object_not_in_list, kNoPart, known.object,
            "the list along " + axis_name(list.axis) + " has " + std::to_string(ends[known.object]) +
                " ends of " + text_of(known.object));
  }

  void check_pairs() {
    std::vector<Pair> tested = parts_.tested;
    std::ranges::sort(tested);
    for (const Pair& pair : pairs_) {
      const bool is_met = parts_.tells_tested ? std::ranges::binary_search(tested, pair) : shares_cell(pair);
      if (is_met && meets_in_lists(pair)) continue;
      add(Kind::pair_never_tested, kNoPart, pair.a,
          "the pair of objects " + number_of(pair.a) + " and " + number_of(pair.b) +
              " was reported, but the structure never brings them together");
    }
  }

  /// Boxes that overlap reach a common cell where all that reach a cell are in it.
  [[nodiscard]] bool shares_cell(const Pair& pair) const {
    if (parts_.holding != Holding::reaching || parts_.cells.empty()) return true;
    return std::ranges::any_of(members_, [&](const CellMember& member) {
      return member.object == pair.a && std::ranges::binary_search(members_, CellMember{member.cell, pair.b});
    });
  }

  /// Along each listed axis the later of the two begins before the other ends.
  [[nodiscard]] bool meets_in_lists(const Pair& pair) const {
    const auto a = boxes_.find(pair.a);
    const auto b = boxes_.find(pair.b);
    if (a == boxes_.end() || b == boxes_.end()) return false;
    return std::ranges::all_of(parts_.lists, [&](const AxisList& list) {
      return a->second.min[list.axis] <= b->second.max[list.axis] &&
             b->second.min[list.axis] <= a->second.max[list.axis];
    });
  }

  const StructureParts<D>& parts_;
  std::span<const KnownObject<D>> objects_;
  std::span<const Pair> pairs_;
  const StructureLimits& limits_;
  const StructureNames& names_;
  std::vector<CellMember> members_;  ///< sorted
  std::vector<std::vector<std::uint32_t>> children_;
  std::unordered_map<ObjectId, Box<D>> boxes_;
  std::vector<StructureFault> faults_;
};

}  // namespace

/// Rounding to the same decimal keeps the order of numbers: of those with one decimal in both tables, which a
/// hand may have written, that decides.
double BoundTolerance::allowed(double outer, double inner) const {
  const bool keeps_order = outer_digits.decimals == 1 && inner_digits.decimals == 1 && !outer_digits.coarse &&
                           !inner_digits.coarse;
  BoundTolerance ordered = *this;
  if (keeps_order) ordered.outer_digits.decimals = ordered.inner_digits.decimals = 0;
  return ordered.allowed_apart(outer, inner);
}

double BoundTolerance::allowed_apart(double outer, double inner) const {
  using Float = std::numeric_limits<Scalar>;
  const double least = std::min({std::abs(outer), std::abs(inner), double{Float::max()}});
  return share * least + ulps * (least * double{Float::epsilon()} + double{Float::denorm_min()}) +
         rounded_away(outer_digits, outer) + rounded_away(inner_digits, inner);
}

template <int D>
bool holds_rounded(const Box<D>& outer, const Box<D>& inner, const BoundTolerance& tolerance) {
  for (int axis = 0; axis < D; ++axis)
    if (begins_before(inner, outer, axis, tolerance) || ends_beyond(inner, outer, axis, tolerance))
      return false;
  return true;
}

template <int D>
std::string how_outside(const Box<D>& inner, const Box<D>& outer, const BoundTolerance& tolerance) {
  for (int axis = 0; axis < D; ++axis) {
    if (begins_before(inner, outer, axis, tolerance))
      return "along " + axis_name(axis) + " it begins at " + shortest_text(inner.min[axis]) + ", before " +
             shortest_text(outer.min[axis]);
    if (ends_beyond(inner, outer, axis, tolerance))
      return "along " + axis_name(axis) + " it ends at " + shortest_text(inner.max[axis]) + ", beyond " +
             shortest_text(outer.max[axis]);
  }
  return "its box is none";
}

std::string_view to_string(StructureFaultKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

template <int D>
std::vector<StructureFault> check_structure(const StructureParts<D>& parts,
                                            std::span<const KnownObject<D>> objects,
                                            std::span<const Pair> pairs, const StructureLimits& limits,
                                            const StructureNames& names) {
  const DefaultFloats floats;
  return Checker<D>(parts, objects, pairs, limits, names).run();
}

#define KERF_INSTANTIATE(D)                                                              \
  template std::string how_outside(const Box<D>&, const Box<D>&, const BoundTolerance&); \
  template bool holds_rounded(const Box<D>&, const Box<D>&, const BoundTolerance&);      \
  template std::vector<StructureFault> check_structure(                                  \
      const StructureParts<D>&, std::span<const KnownObject<D>>, std::span<const Pair>,  \
      const StructureLimits&, const StructureNames&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

#include "core/query/explain_their_search.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/float_mode.h"
#include "core/query/text.h"
#include "core/query/their_parts.h"

namespace kerf {
namespace {

template <int D>
class Searches {
 public:
  Searches(const TheirStructure<D>& structure, const ObjectTable<D>& objects, const GivenNames& names)
      : structure_(structure),
        objects_(objects),
        names_(names),
        parts_(parts_of(structure).parts),
        tolerance_(tolerance_of(structure.digits)) {}

  std::string run(const Pair& pair) {
    text_ = "in the other engine's structure:\n";
    for (const ObjectId object : {pair.a, pair.b}) tell_places(object);
    const bool finds_b = search(pair.a, pair.b);
    const bool finds_a = search(pair.b, pair.a);
    if (finds_a && finds_b)
      text_ += "  its nodes bring the two together: if the pair was missed, it was lost behind them\n";
    return std::move(text_);
  }

 private:
  [[nodiscard]] std::string name(std::uint32_t cell) const {
    return node_name(structure_, parts_.cells[cell].name);
  }
  [[nodiscard]] std::string object_text(ObjectId object) const { return "object " + names_.object(object); }

  [[nodiscard]] std::vector<std::uint32_t> cells_of(ObjectId object) const {
    std::vector<std::uint32_t> cells;
    for (const CellMember& member : parts_.members)
      if (member.object == object) cells.push_back(member.cell);
    return cells;
  }

  void tell_places(ObjectId object) {
    const auto cells = cells_of(object);
    for (const std::uint32_t cell : cells)
      text_ += "  " + object_text(object) + " is in " + name(cell) + " at depth " +
               std::to_string(parts_.cells[cell].depth) + ", " + box_text(parts_.cells[cell].box) + "\n";
    if (cells.empty())
      text_ += "  " + object_text(object) + " is in no node: its leaf is lost, or was not put in again\n";
  }

  [[nodiscard]] std::vector<std::uint32_t> way_to(std::uint32_t cell) const {
    std::vector<std::uint32_t> way;
    for (; cell != kNoPart; cell = parts_.cells[cell].parent) way.push_back(cell);
    std::ranges::reverse(way);
    return way;
  }

  [[nodiscard]] Box<D> box_of(std::uint32_t start, ObjectId from) const {
    return start == kNoPart ? objects_.box(from) : parts_.cells[start].box;
  }

  /// The first cell of a way that a box does not reach; none: it reaches them all.
  [[nodiscard]] std::uint32_t stop_of(const Box<D>& box, const std::vector<std::uint32_t>& way) const {
    const auto stop =
        std::ranges::find_if(way, [&](std::uint32_t cell) { return !overlaps(parts_.cells[cell].box, box); });
    return stop == way.end() ? kNoPart : *stop;
  }

  /// Adds what becomes of a search for `wanted`, from any of one object's nodes to any of the other's.
  /// Whether one finds it.
  bool search(ObjectId from, ObjectId wanted) {
    const auto targets = cells_of(wanted);
    if (targets.empty()) return false;  // said already
    auto starts = cells_of(from);
    if (starts.empty()) starts.push_back(kNoPart);
    for (const std::uint32_t start : starts)
      for (const std::uint32_t target : targets)
        if (stop_of(box_of(start, from), way_to(target)) == kNoPart) {
          tell_search(start, from, way_to(target), wanted);
          return true;
        }
    tell_search(starts.front(), from, way_to(targets.front()), wanted);
    return false;
  }

  void tell_search(std::uint32_t start, ObjectId from, const std::vector<std::uint32_t>& way,
                   ObjectId wanted) {
    const std::uint32_t stop = stop_of(box_of(start, from), way);
    text_ += "  a search with the box of " + (start == kNoPart ? object_text(from) : name(start)) + " for " +
             object_text(wanted);
    if (stop == kNoPart) {
      text_ += " finds it\n";
    } else {
      text_ += " ends at " + name(stop) + " at depth " + std::to_string(parts_.cells[stop].depth) +
               ", which it does not reach: " + box_text(parts_.cells[stop].box) + "\n";
    }
    tell_fault(fault_text(way, wanted));
    tell_fault(fault_of_object(start, from));
  }

  /// Each once: both searches may come by it.
  void tell_fault(const std::string& fault) {
    if (text_.find(fault) == std::string::npos) text_ += fault;
  }

  /// Why the way from the root to an object does not cover it: the first node that lies outside of its
  /// parent.
  [[nodiscard]] std::string fault_text(const std::vector<std::uint32_t>& way, ObjectId wanted) const {
    for (std::size_t k = 1; k < way.size(); ++k) {
      const Box<D>& outer = parts_.cells[way[k - 1]].box;
      const Box<D>& inner = parts_.cells[way[k]].box;
      if (!holds_rounded(outer, inner, tolerance_.child))
        return "    the fault: " + name(way[k]) + " lies outside its parent " + name(way[k - 1]) + ": " +
               how_outside(inner, outer, tolerance_.child) + ". A refit was forgotten\n";
    }
    return fault_of_object(way.back(), wanted);
  }

  [[nodiscard]] std::string fault_of_object(std::uint32_t cell, ObjectId object) const {
    if (cell == kNoPart || holds_rounded(parts_.cells[cell].box, objects_.box(object), tolerance_.object))
      return "";
    return "    the fault: " + object_text(object) + " lies outside its node " + name(cell) + ": " +
           how_outside(objects_.box(object), parts_.cells[cell].box, tolerance_.object) +
           ". It was not put in again\n";
  }

  const TheirStructure<D>& structure_;
  const ObjectTable<D>& objects_;
  const GivenNames& names_;
  StructureParts<D> parts_;
  StructureTolerance tolerance_;
  std::string text_;
};

}  // namespace

template <int D>
std::string explain_their_search(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                 const Pair& pair, const GivenNames& names) {
  const DefaultFloats floats;
  if (!objects.is_placed(pair.a) || !objects.is_placed(pair.b)) return "";
  return Searches<D>(structure, objects, names).run(pair);
}

template std::string explain_their_search(const TheirStructure<2>&, const ObjectTable<2>&, const Pair&,
                                          const GivenNames&);
template std::string explain_their_search(const TheirStructure<3>&, const ObjectTable<3>&, const Pair&,
                                          const GivenNames&);

}  // namespace kerf

#include "core/query/explain_their_search.h"

#include <algorithm>
#include <vector>

#include "core/query/text.h"
#include "core/query/their_parts.h"

namespace kerf {
namespace {

template <int D>
class Searches {
 public:
  Searches(const TheirStructure<D>& structure, const ObjectTable<D>& objects, const GivenNames& names)
      : structure_(structure), objects_(objects), names_(names), parts_(parts_of(structure).parts) {}

  std::string run(const Pair& pair) {
    std::string text = "in the other engine's structure:\n";
    for (const ObjectId object : {pair.a, pair.b}) text += "  " + place_text(object) + "\n";
    const bool found = search(pair.a, pair.b, text) & search(pair.b, pair.a, text);
    if (found)
      text += "  its nodes bring the two together: if the pair was missed, it was lost behind them\n";
    return text;
  }

 private:
  [[nodiscard]] std::string name(std::uint32_t cell) const {
    return node_name(structure_, parts_.cells[cell].name);
  }
  [[nodiscard]] std::string object_text(ObjectId object) const { return "object " + names_.object(object); }

  /// The first cell that holds it.
  [[nodiscard]] std::uint32_t cell_of(ObjectId object) const {
    const auto found = std::ranges::find(parts_.members, object, &CellMember::object);
    return found == parts_.members.end() ? kNoPart : found->cell;
  }

  [[nodiscard]] std::string place_text(ObjectId object) const {
    const std::uint32_t cell = cell_of(object);
    if (cell == kNoPart)
      return object_text(object) + " is in no node: its leaf is lost, or was not put in again";
    return object_text(object) + " is in " + name(cell) + " at depth " +
           std::to_string(parts_.cells[cell].depth) + ", " + box_text(parts_.cells[cell].box);
  }

  [[nodiscard]] std::vector<std::uint32_t> way_to(std::uint32_t cell) const {
    std::vector<std::uint32_t> way;
    for (; cell != kNoPart; cell = parts_.cells[cell].parent) way.push_back(cell);
    std::ranges::reverse(way);
    return way;
  }

  /// Adds what becomes of a search for `wanted`; whether it finds it.
  [[nodiscard]] bool search(ObjectId from, ObjectId wanted, std::string& text) const {
    const std::uint32_t target = cell_of(wanted);
    if (target == kNoPart) return false;  // said already
    const std::uint32_t start = cell_of(from);
    const Box<D> box = start == kNoPart ? objects_.box(from) : parts_.cells[start].box;
    const std::string what = "a search with the box of " +
                             (start == kNoPart ? object_text(from) : name(start)) + " for " +
                             object_text(wanted);
    const auto way = way_to(target);
    const auto stop =
        std::ranges::find_if(way, [&](std::uint32_t cell) { return !overlaps(parts_.cells[cell].box, box); });
    if (stop == way.end()) {
      text += "  " + what + " finds it\n";
      return true;
    }
    text += "  " + what + " ends at " + name(*stop) + " at depth " +
            std::to_string(parts_.cells[*stop].depth) +
            ", which it does not reach: " + box_text(parts_.cells[*stop].box) + "\n";
    text += fault_text(way, wanted) + fault_of_object(start, from);
    return false;
  }

  /// Why the way from the root to an object does not cover it: the first node that lies outside of its
  /// parent.
  [[nodiscard]] std::string fault_text(const std::vector<std::uint32_t>& way, ObjectId wanted) const {
    for (std::size_t k = 1; k < way.size(); ++k) {
      const Box<D>& outer = parts_.cells[way[k - 1]].box;
      const Box<D>& inner = parts_.cells[way[k]].box;
      if (!holds_rounded(outer, inner, kSixDigits))
        return "    the fault: " + name(way[k]) + " lies outside its parent " + name(way[k - 1]) + ": " +
               how_outside(inner, outer, kSixDigits) + ". A refit was forgotten\n";
    }
    return fault_of_object(way.back(), wanted);
  }

  [[nodiscard]] std::string fault_of_object(std::uint32_t cell, ObjectId object) const {
    if (cell == kNoPart || holds_rounded(parts_.cells[cell].box, objects_.box(object), kSixDigits)) return "";
    return "    the fault: " + object_text(object) + " lies outside its node " + name(cell) + ": " +
           how_outside(objects_.box(object), parts_.cells[cell].box, kSixDigits) +
           ". It was not put in again\n";
  }

  const TheirStructure<D>& structure_;
  const ObjectTable<D>& objects_;
  const GivenNames& names_;
  StructureParts<D> parts_;
};

}  // namespace

template <int D>
std::string explain_their_search(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                 const Pair& pair, const GivenNames& names) {
  if (!objects.is_placed(pair.a) || !objects.is_placed(pair.b)) return "";
  return Searches<D>(structure, objects, names).run(pair);
}

template std::string explain_their_search(const TheirStructure<2>&, const ObjectTable<2>&, const Pair&,
                                          const GivenNames&);
template std::string explain_their_search(const TheirStructure<3>&, const ObjectTable<3>&, const Pair&,
                                          const GivenNames&);

}  // namespace kerf

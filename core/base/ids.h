#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace kerf {

/// A 32-bit index with a type of its own, so that an object is never mistaken for a node.
/// `Id::none()` is the one value that names nothing.
template <class Tag>
struct Id {
  std::uint32_t value = UINT32_MAX;

  static constexpr Id none() { return Id{}; }
  [[nodiscard]] constexpr bool is_none() const { return value == UINT32_MAX; }
  /// The position in an array kept per id.
  [[nodiscard]] constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

/// An object of the scene. The caller chooses these numbers; small, dense ones cost least memory.
using ObjectId = Id<struct ObjectTag>;
/// A node of the tree. A dead node's number is used again; `NodeRef` distinguishes the two lives.
using NodeId = Id<struct NodeTag>;

/// One life of a node: the number together with the generation that it had when it was named.
struct NodeRef {
  NodeId node;
  std::uint32_t generation = 0;
  friend constexpr bool operator==(const NodeRef&, const NodeRef&) = default;
};

/// A candidate pair: two objects whose boxes overlap in the closed sense, `a < b`. (A KeptLeaf may name them
/// by their places.)
struct Pair {
  ObjectId a;
  ObjectId b;
  friend constexpr auto operator<=>(const Pair&, const Pair&) = default;
};

/// The pair of two different objects in canonical order.
constexpr Pair make_pair(ObjectId i, ObjectId j) { return i < j ? Pair{i, j} : Pair{j, i}; }

}  // namespace kerf

template <class Tag>
struct std::hash<kerf::Id<Tag>> {
  std::size_t operator()(kerf::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};

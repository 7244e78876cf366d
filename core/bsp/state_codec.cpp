#include "core/bsp/state_codec.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/bsp/state_check.h"

namespace kerf {
namespace {

// There are arrays with a place for each number of an object or node, used or not: a keyframe has a byte for
// so many.
constexpr std::size_t kAlwaysPlaces = 65'536;
constexpr std::size_t kPlacesForAByte = 8;

std::size_t least_keyframe(std::size_t places) {
  return places <= kAlwaysPlaces ? 0 : (places - kAlwaysPlaces) / kPlacesForAByte;
}

void check_places(std::size_t places, std::size_t size, const char* what) {
  if (least_keyframe(places) > size)
    fail_damaged("a keyframe of " + counted(size, "byte") + " says that it has " + counted(places, what));
}

template <int D>
void put_table(const ObjectTable<D>& table, ByteWriter& out) {
  out.varint(table.bound());
  for (std::uint32_t id = 0; id < table.bound(); ++id) {
    out.u8(static_cast<std::uint8_t>(table.state({id})));
    out.u8(table.is_fixed({id}) ? 1 : 0);
    if (!table.is_placed({id})) continue;
    const Box<D> box = table.box({id});
    for (int axis = 0; axis < D; ++axis) {
      out.f32(box.min[axis]);
      out.f32(box.max[axis]);
    }
    for (int k = 0; k < extra_size<D>(table.kind()); ++k) out.f32(table.extra({id})[k]);
  }
}

template <int D>
Volume<D> get_volume(ByteReader& in, VolumeKind kind) {
  Volume<D> volume;
  volume.kind = kind;
  for (int axis = 0; axis < D; ++axis) {
    volume.box.min[axis] = in.f32();
    volume.box.max[axis] = in.f32();
  }
  for (int k = 0; k < extra_size<D>(kind); ++k) volume.extra[static_cast<std::size_t>(k)] = in.f32();
  return volume;
}

/// Brings each object into its state by the requests that lead there. `size` is the keyframe's.
template <int D>
void get_table(ByteReader& in, std::size_t size, ObjectTable<D>& table) {
  constexpr std::size_t kLeast = 2;  // bytes of an object: its state and its mobility
  const Box<D> invalid = Box<D>::empty();
  const std::size_t bound = in.count(kLeast);
  check_places(bound, size, "object");
  table.make_room(bound);
  for (std::uint32_t id = 0; id < bound; ++id) {
    const auto state = static_cast<ObjectState>(in.choice(3));
    const Mobility mobility = in.choice(2) == 0 ? Mobility::moving : Mobility::fixed;
    if (state == ObjectState::placed) {
      if (table.insert(ObjectId{id}, get_volume<D>(in, table.kind()), mobility) != Status::ok)
        fail_damaged("a keyframe has an object " + std::to_string(id) + " with a box that cannot be placed");
      continue;
    }
    (void)table.insert(ObjectId{id}, invalid, mobility);
    if (state == ObjectState::absent) (void)table.remove({id});
  }
}

void put_ref(const NodeRef& ref, ByteWriter& out) {
  out.varint(ref.node.value);
  out.varint(ref.generation);
}

NodeRef get_ref(ByteReader& in) {
  const std::uint32_t node = in.number();
  return {{node}, in.number()};
}

template <int D>
void put_node(const Node<D>& node, ByteWriter& out) {
  out.varint(node.generation);
  out.u8(static_cast<std::uint8_t>((node.alive ? 1U : 0U) | (node.unsorted ? 2U : 0U)));
  if (!node.alive) return;
  out.varint(node.direction);
  for (const NodeId link : {node.parent, node.left, node.right}) out.u32(link.value);
  out.f32(node.plane.offset);
  for (const std::uint32_t x : {node.depth, node.population, node.retry_step, node.refusals}) out.varint(x);
  out.u64(node.right_of);
  out.varint(node.entries.size());
  for (const Entry& entry : node.entries) {
    out.f32(entry.key.lo);
    out.f32(entry.key.hi);
    out.varint(entry.object.value);
    out.varint(entry.straddle);
  }
}

constexpr std::size_t kLeastOfEntry = 10;  ///< bytes: two ends, a number, a mask

template <int D>
Node<D> get_node(ByteReader& in, const DirectionSet<D>& directions, std::size_t objects) {
  Node<D> node;
  node.generation = in.number();
  const std::uint8_t flags = in.choice(4);
  node.alive = (flags & 1U) != 0;
  node.unsorted = (flags & 2U) != 0;
  if (!node.alive) return node;
  node.direction = in.number();
  for (NodeId* link : {&node.parent, &node.left, &node.right}) link->value = in.u32();
  const Scalar offset = in.f32();
  for (std::uint32_t* x : {&node.depth, &node.population, &node.retry_step, &node.refusals}) *x = in.number();
  node.right_of = in.u64();
  if (node.direction >= directions.size()) fail_damaged("a keyframe has a partitioner of no direction");
  if (!node.is_leaf()) node.plane = {directions[node.direction], offset};
  node.entries.resize(in.count(kLeastOfEntry));
  for (Entry& entry : node.entries) {
    entry.key.lo = in.f32();
    entry.key.hi = in.f32();
    entry.object.value = in.number();
    entry.straddle = in.varint();
    if (entry.object.index() >= objects) fail_damaged("a keyframe names no object");
  }
  return node;
}

template <int D>
void put_tree(const Tree<D>& tree, ByteWriter& out) {
  put_table(tree.table, out);
  out.varint(tree.nodes().size());
  for (const Node<D>& node : tree.nodes()) put_node(node, out);
  out.varint(tree.unused().size());
  for (const NodeId id : tree.unused()) out.varint(id.value);
  out.varint(tree.root().value);
}

template <int D>
void get_tree(ByteReader& in, std::size_t size, Tree<D>& tree) {
  constexpr std::size_t kLeast = 2;  // bytes of a node: its generation and its flags
  get_table(in, size, tree.table);
  const std::size_t count = in.count(kLeast);
  check_places(count, size, "node");
  std::vector<Node<D>> nodes(count);
  for (Node<D>& node : nodes) node = get_node(in, tree.directions(), tree.table.bound());
  std::vector<NodeId> unused(in.count());
  for (NodeId& id : unused) id.value = in.number();
  const NodeId root{in.number()};
  try {
    tree.assign(std::move(nodes), std::move(unused), root);
  } catch (const std::runtime_error& error) {
    fail_damaged(error.what());
  }
}

template <int D>
void put_scheduler(const Scheduler<D>& scheduler, ByteWriter& out) {
  for (int op = 0; op < kOperatorCount; ++op) {
    const std::vector<NodeRef>& list = scheduler.listed(static_cast<Operator>(op));
    out.varint(list.size());
    for (const NodeRef& ref : list) put_ref(ref, out);
    out.varint(scheduler.acted()[static_cast<std::size_t>(op)]);
  }
  out.varint(scheduler.refused());
}

template <int D>
void get_scheduler(ByteReader& in, Scheduler<D>& scheduler) {
  constexpr std::size_t kLeast = 2;  // bytes of a node and its generation
  std::array<std::vector<NodeRef>, kOperatorCount> lists;
  std::array<std::uint64_t, kOperatorCount> acted{};
  for (std::size_t op = 0; op < kOperatorCount; ++op) {
    lists[op].resize(in.count(kLeast));
    for (NodeRef& ref : lists[op]) ref = get_ref(in);
    acted[op] = in.varint();
  }
  scheduler.resume(std::move(lists), acted, in.varint());
}

std::uint16_t get_short(ByteReader& in) {
  const std::uint32_t x = in.number();
  if (x > UINT16_MAX) fail_damaged("a number has more than 16 bits");
  return static_cast<std::uint16_t>(x);
}

Skin get_skin(ByteReader& in) {
  constexpr std::uint8_t kWraps = 17;  // each doubles a number of steps
  Skin skin;
  skin.level = in.choice(Skin::kThickest + 1);
  skin.wrapped = in.choice(2) != 0;
  skin.wraps = in.choice(kWraps);
  skin.since = get_short(in);
  skin.restless = in.choice(Skin::kRestless + 1);
  skin.seen = get_short(in);
  return skin;
}

constexpr std::size_t kLeastOfSkin = 6;  ///< bytes: one for each field

Config get_config(ByteReader& in) {
  const auto text = in.blob();
  try {
    Config config;
    kerf::apply(config, std::string(text.begin(), text.end()));
    return config;
  } catch (const std::invalid_argument& error) {
    fail_damaged(std::string("a keyframe's configuration: ") + error.what());
  }
}

}  // namespace

template <int D>
Bytes encode_state(const BspState<D>& state) {
  ByteWriter out;
  put_table(state.latest, out);
  out.text(to_string(state.config));
  put_tree(state.tree, out);
  put_scheduler(state.scheduler, out);
  out.varint(state.skins.size());
  for (const Skin& skin : state.skins) {
    out.u8(skin.level);
    out.u8(skin.wrapped ? 1 : 0);
    out.u8(skin.wraps);
    out.varint(skin.since);
    out.u8(skin.restless);
    out.varint(skin.seen);
  }
  out.u8(static_cast<std::uint8_t>(state.modes.mode()));
  for (const std::uint32_t x : state.modes.memory()) out.varint(x);
  out.varint(state.placed);
  out.varint(state.next_event);
  out.varint(state.step);
  return {out.bytes().begin(), out.bytes().end()};
}

template <int D>
std::size_t least_bytes(const BspState<D>& state) {
  const std::size_t objects = std::max(state.latest.bound(), state.tree.table.bound());
  return least_keyframe(std::max(objects, state.tree.nodes().size()));
}

template <int D>
BspState<D> decode_state(std::span<const std::uint8_t> bytes, std::size_t size,
                         std::shared_ptr<const Projector<D>> projector) {
  const DefaultFloats floats;
  ByteReader in(bytes);
  const VolumeKind kind = projector->kind();
  BspState<D> state{{}, Tree<D>(std::move(projector)), {}, ObjectTable<D>(kind), {}, {}};
  get_table(in, size, state.latest);
  state.config = get_config(in);
  get_tree(in, size, state.tree);
  get_scheduler(in, state.scheduler);
  state.skins.resize(in.count(kLeastOfSkin));
  for (Skin& skin : state.skins) skin = get_skin(in);
  const auto mode = static_cast<Mode>(in.choice(kModeCount));
  ModeChooser::Memory memory{};
  for (std::uint32_t& x : memory) x = in.number();
  state.modes.resume(mode, memory);
  state.placed = in.varint();
  state.next_event = in.varint();
  state.step = in.number();
  if (!in.empty()) fail_damaged("a keyframe holds more than its tree");
  if (const std::string fault = fault_of(state); !fault.empty()) fail_damaged("a keyframe's tree: " + fault);
  return state;
}

template <int D>
ObjectTable<D> decode_state_objects(std::span<const std::uint8_t> bytes, std::size_t size, VolumeKind kind) {
  ByteReader in(bytes);
  ObjectTable<D> objects(kind);
  get_table(in, size, objects);
  return objects;
}

#define KERF_INSTANTIATE(D)                                                        \
  template Bytes encode_state<D>(const BspState<D>&);                              \
  template std::size_t least_bytes<D>(const BspState<D>&);                         \
  template BspState<D> decode_state<D>(std::span<const std::uint8_t>, std::size_t, \
                                       std::shared_ptr<const Projector<D>>);       \
  template ObjectTable<D> decode_state_objects<D>(std::span<const std::uint8_t>, std::size_t, VolumeKind);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

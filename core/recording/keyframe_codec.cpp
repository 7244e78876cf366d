#include "core/recording/keyframe_codec.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/recording/compression.h"

namespace kerf {
namespace {

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

/// Each object is brought into its state by the requests that lead there.
template <int D>
void get_table(ByteReader& in, ObjectTable<D>& table) {
  Box<D> invalid = Box<D>::empty();
  const std::size_t bound = in.count();
  for (std::uint32_t id = 0; id < bound; ++id) {
    const auto state = static_cast<ObjectState>(in.u8());
    const Mobility mobility = in.u8() == 0 ? Mobility::moving : Mobility::fixed;
    if (state == ObjectState::placed) {
      (void)table.insert(ObjectId{id}, get_volume<D>(in, table.kind()), mobility);
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
  const auto node = static_cast<std::uint32_t>(in.varint());
  return {{node}, static_cast<std::uint32_t>(in.varint())};
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

template <int D>
Node<D> get_node(ByteReader& in, const DirectionSet<D>& directions, std::size_t objects) {
  Node<D> node;
  node.generation = static_cast<std::uint32_t>(in.varint());
  const std::uint8_t flags = in.u8();
  node.alive = (flags & 1U) != 0;
  node.unsorted = (flags & 2U) != 0;
  if (!node.alive) return node;
  node.direction = static_cast<std::uint32_t>(in.varint());
  for (NodeId* link : {&node.parent, &node.left, &node.right}) link->value = in.u32();
  const Scalar offset = in.f32();
  for (std::uint32_t* x : {&node.depth, &node.population, &node.retry_step, &node.refusals})
    *x = static_cast<std::uint32_t>(in.varint());
  node.right_of = in.u64();
  if (!node.is_leaf() && node.direction < directions.size())
    node.plane = {directions[node.direction], offset};
  node.entries.resize(in.count());
  for (Entry& entry : node.entries) {
    entry.key.lo = in.f32();
    entry.key.hi = in.f32();
    entry.object.value = static_cast<std::uint32_t>(in.varint());
    entry.straddle = in.varint();
    if (entry.object.index() >= objects)
      throw std::runtime_error("the recording is damaged: a keyframe names no object");
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
void get_tree(ByteReader& in, Tree<D>& tree) {
  get_table(in, tree.table);
  std::vector<Node<D>> nodes(in.count());
  for (Node<D>& node : nodes) node = get_node(in, tree.directions(), tree.table.bound());
  std::vector<NodeId> unused(in.count());
  for (NodeId& id : unused) id.value = static_cast<std::uint32_t>(in.varint());
  tree.assign(std::move(nodes), std::move(unused), {static_cast<std::uint32_t>(in.varint())});
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
  std::array<std::vector<NodeRef>, kOperatorCount> lists;
  std::array<std::uint64_t, kOperatorCount> acted{};
  for (std::size_t op = 0; op < kOperatorCount; ++op) {
    lists[op].resize(in.count());
    for (NodeRef& ref : lists[op]) ref = get_ref(in);
    acted[op] = in.varint();
  }
  scheduler.resume(std::move(lists), acted, in.varint());
}

Skin get_skin(ByteReader& in) {
  constexpr std::uint8_t kMostWraps = 16;  // each doubles a number of steps
  Skin skin;
  skin.level = std::min(in.u8(), Skin::kThickest);
  skin.wrapped = in.u8() != 0;
  skin.wraps = std::min(in.u8(), kMostWraps);
  skin.since = static_cast<std::uint16_t>(in.varint());
  skin.restless = std::min(in.u8(), Skin::kRestless);
  skin.seen = static_cast<std::uint16_t>(in.varint());
  return skin;
}

}  // namespace

template <int D>
Bytes encode_keyframe(const BspState<D>& state) {
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
  return compress(out.bytes());
}

template <int D>
BspState<D> decode_keyframe(std::span<const std::uint8_t> bytes,
                            std::shared_ptr<const Projector<D>> projector) {
  const Bytes plain = decompress(bytes);
  ByteReader in(plain);
  const VolumeKind kind = projector->kind();
  BspState<D> state{{}, Tree<D>(std::move(projector)), {}, ObjectTable<D>(kind), {}, {}};
  get_table(in, state.latest);
  const auto config = in.blob();
  kerf::apply(state.config, std::string(config.begin(), config.end()));
  get_tree(in, state.tree);
  get_scheduler(in, state.scheduler);
  state.skins.resize(in.count());
  for (Skin& skin : state.skins) skin = get_skin(in);
  const std::uint8_t mode = in.u8();
  if (mode >= kModeCount) throw std::runtime_error("the recording is damaged: a keyframe has no known mode");
  ModeChooser::Memory memory{};
  for (std::uint32_t& x : memory) x = static_cast<std::uint32_t>(in.varint());
  state.modes.resume(static_cast<Mode>(mode), memory);
  state.placed = in.varint();
  state.next_event = in.varint();
  state.step = static_cast<std::uint32_t>(in.varint());
  return state;
}

template <int D>
ObjectTable<D> decode_keyframe_objects(std::span<const std::uint8_t> bytes, VolumeKind kind) {
  const Bytes plain = decompress(bytes);
  ByteReader in(plain);
  ObjectTable<D> objects(kind);
  get_table(in, objects);
  return objects;
}

#define KERF_INSTANTIATE(D)                                                     \
  template Bytes encode_keyframe<D>(const BspState<D>&);                        \
  template BspState<D> decode_keyframe<D>(std::span<const std::uint8_t>,        \
                                          std::shared_ptr<const Projector<D>>); \
  template ObjectTable<D> decode_keyframe_objects<D>(std::span<const std::uint8_t>, VolumeKind);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

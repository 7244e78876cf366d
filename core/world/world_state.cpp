// A world as bytes: mark, version, dimension, options, handles, objects, reports, tree, checksum.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/bytes.h"
#include "core/base/float_mode.h"
#include "core/bsp/bsp_state.h"
#include "core/bsp/state_codec.h"
#include "core/world/seal.h"
#include "core/world/world.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMark = 0x4457464BU;  // "KFWD"
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kSealSize = 8;

void put_reports(std::span<const WorldPair> pairs, ByteWriter& out) {
  out.varint(pairs.size());
  for (const WorldPair& pair : pairs) {
    out.u64(pair.a.value);
    out.u64(pair.b.value);
    out.u8(static_cast<std::uint8_t>(pair.flags));
  }
}

/// In the order of reports, each once.
std::vector<WorldPair> get_reports(ByteReader& in, const Slots& slots) {
  constexpr std::size_t kSize = 17;  // bytes of a pair
  std::vector<WorldPair> pairs(in.count(kSize));
  const WorldPair* before = nullptr;
  for (WorldPair& pair : pairs) {
    pair.a.value = in.u64();
    pair.b.value = in.u64();
    pair.flags = in.choice(2);
    if (pair.a.index() >= pair.b.index() || pair.b.index() >= slots.size() ||
        slots.handle(pair.a.index()) != pair.a || slots.handle(pair.b.index()) != pair.b)
      fail_damaged("a pair is of no two objects");
    if (before != nullptr &&
        std::pair(before->a.index(), before->b.index()) >= std::pair(pair.a.index(), pair.b.index()))
      fail_damaged("pairs are not in their order");
    before = &pair;
  }
  return pairs;
}

void put_def(const ObjectDef& def, ByteWriter& out) {
  out.u8(static_cast<std::uint8_t>(def.kind));
  out.f32(def.margin);
  out.varint(def.filter.category);
  out.varint(def.filter.mask);
  out.varint(zigzag(def.filter.group));
  out.varint(def.user_data);
}

ObjectDef get_def(ByteReader& in) {
  ObjectDef def;
  def.kind = static_cast<ObjectKind>(in.choice(kObjectKinds));
  def.margin = in.f32();
  def.filter.category = in.varint();
  def.filter.mask = in.varint();
  def.filter.group = unzigzag(in.number());
  def.user_data = in.varint();
  if (!is_margin(def.margin)) fail_damaged("a margin is no thickness");
  return def;
}

}  // namespace

/// Writes and reads the private parts of a world.
template <int D>
class WorldCodec {
 public:
  static Bytes encode(const World<D>& world) {
    ByteWriter out;
    out.u32(kMark);
    out.u8(kVersion);
    out.u8(D);
    out.text(to_string(world.options_.config));
    out.u8(static_cast<std::uint8_t>(world.options_.pairs_of));
    out.u8(world.options_.tag);
    put_objects(world, out);
    put_reports(world.pairs_, out);
    put_reports(world.begun_, out);
    put_reports(world.ended_, out);
    out.blob(encode_state(world.tree_->state()));
    out.u64(seal_of(out.bytes()));
    return {out.bytes().begin(), out.bytes().end()};
  }

  static World<D> decode(std::span<const std::uint8_t> bytes) {
    ByteReader in(open(bytes));
    WorldOptions options;
    options.config = get_config(in);
    options.pairs_of = static_cast<PairsOf>(in.choice(2));
    options.tag = in.u8();
    World<D> world(options);
    get_objects(in, world);
    world.pairs_ = get_reports(in, world.slots_);
    world.begun_ = get_reports(in, world.slots_);
    world.ended_ = get_reports(in, world.slots_);
    take_rows(world);
    get_tree(in.blob(), world);
    check_reports(world);
    if (!in.empty()) fail_damaged("there is more than a world");
    return world;
  }

 private:
  /// Checks mark, version, dimension and seal; returns what lies between.
  static std::span<const std::uint8_t> open(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kHead = 6;
    if (bytes.size() < kHead + kSealSize) fail_damaged("these bytes are too few");
    ByteReader in(bytes);
    if (in.u32() != kMark) fail_damaged("these bytes are no world's");
    const std::uint8_t version = in.u8();
    if (version != kVersion)
      fail_damaged("it has version " + std::to_string(version) + ", and this Kerf reads version " +
                   std::to_string(kVersion));
    const std::uint8_t dimension = in.u8();
    if (dimension != D) fail_damaged("its world has " + std::to_string(dimension) + " dimensions");
    const auto sealed = bytes.first(bytes.size() - kSealSize);
    if (ByteReader(bytes.last(kSealSize)).u64() != seal_of(sealed))
      fail_damaged("its checksum is another: bytes were changed or lost");
    return sealed.subspan(kHead);
  }

  static Config get_config(ByteReader& in) {
    const auto text = in.blob();
    try {
      Config config;
      kerf::apply(config, std::string(text.begin(), text.end()));
      check(config);
      return config;
    } catch (const std::invalid_argument& error) {
      fail_damaged(error.what());
    }
  }

  static void put_objects(const World<D>& world, ByteWriter& out) {
    out.varint(world.slots_.size());
    for (const std::uint64_t key : world.slots_.keys()) out.u64(key);
    out.varint(world.slots_.free().size());
    for (const std::uint32_t index : world.slots_.free()) out.varint(index);
    world.slots_.for_each([&](Handle handle) {
      const ObjectDef& def = world.defs_[handle.index()];
      put_def(def, out);
      if (is_thick(def.margin)) put_box(world.exact_[handle.index()], out);
    });
  }

  static void get_objects(ByteReader& in, World<D>& world) {
    std::vector<std::uint64_t> keys(in.count(sizeof(std::uint64_t)));
    for (std::uint64_t& key : keys) key = in.u64();
    std::vector<std::uint32_t> free(in.count());
    for (std::uint32_t& index : free) index = in.number();
    if (!world.slots_.restore(std::move(keys), std::move(free))) fail_damaged("its handles contradict");
    world.defs_.resize(world.slots_.size());
    world.slots_.for_each([&](Handle handle) {
      ObjectDef& def = world.defs_[handle.index()];
      def = get_def(in);
      world.count(def, 1);
      if (!is_thick(def.margin)) return;
      world.exact_.resize(world.slots_.size());
      world.exact_[handle.index()] = get_box(in);
    });
  }

  static void put_box(const Box<D>& box, ByteWriter& out) {
    for (int axis = 0; axis < D; ++axis) {
      out.f32(box.min[axis]);
      out.f32(box.max[axis]);
    }
  }

  static Box<D> get_box(ByteReader& in) {
    Box<D> box;
    for (int axis = 0; axis < D; ++axis) {
      box.min[axis] = in.f32();
      box.max[axis] = in.f32();
    }
    if (!is_valid(box)) fail_damaged("a box is none");
    return box;
  }

  /// The rows of the pairs that the next step is compared with.
  static void take_rows(World<D>& world) {
    std::vector<Pair> pairs;
    pairs.reserve(world.pairs_.size());
    for (const WorldPair& pair : world.pairs_) {
      if (!world.slots_.contains(pair.a) || !world.slots_.contains(pair.b))
        fail_damaged("an object of a pair does not live");
      pairs.push_back({{pair.a.index()}, {make_partner(pair.b.index(), pair.is_sensor()).value}});
    }
    world.rows_.assign_flagged(pairs, world.slots_.size());
  }

  static void get_tree(std::span<const std::uint8_t> bytes, World<D>& world) {
    const BspState<D> state =
        decode_state<D>(bytes, bytes.size(), make_projector<D>(world.options_.config, VolumeKind::box));
    if (state.config != world.options_.config) fail_damaged("its tree has another configuration");
    for (std::uint32_t i = 0; i < state.latest.bound() || i < world.slots_.size(); ++i)
      if (!has_same(world, state.latest, i)) fail_damaged("its tree has other objects");
    world.tree_->restore(state);
  }

  /// What was reported must be what the tree's boxes and the objects say.
  static void check_reports(const World<D>& world) {
    const auto precedes = [](const WorldPair& one, const WorldPair& two) {
      const auto key = [](const WorldPair& pair) {
        return std::tuple(pair.a.index(), pair.b.index(), pair.is_sensor());
      };
      return key(one) < key(two);
    };
    if (!std::ranges::all_of(world.pairs_, [&](const WorldPair& pair) { return is_true(world, pair); }))
      fail_damaged("a pair is none of its objects");
    if (!std::ranges::includes(world.pairs_, world.begun_, precedes))
      fail_damaged("a pair began that is none");
    if (std::ranges::any_of(world.ended_, [&](const WorldPair& pair) {
          return std::ranges::binary_search(world.pairs_, pair, precedes);
        }))
      fail_damaged("a pair ended that is there");
  }

  static bool is_true(const World<D>& world, const WorldPair& pair) {
    const ObjectId a{pair.a.index()};
    const ObjectId b{pair.b.index()};
    const bool has_sensor = world.defs_[a.index()].kind == ObjectKind::sensor ||
                            world.defs_[b.index()].kind == ObjectKind::sensor;
    return pair.is_sensor() == has_sensor && world.tree_->objects().is_pair(a, b) && world.may_report(a, b);
  }

  /// Whether the tree has the object of an index as the world has it.
  static bool has_same(const World<D>& world, const ObjectTable<D>& table, std::uint32_t index) {
    const ObjectId object{index};
    if (index >= world.slots_.size() || !world.slots_.is_alive(index))
      return table.state(object) == ObjectState::absent;
    const ObjectDef& def = world.defs_[index];
    return table.is_placed(object) && table.is_fixed(object) == is_passive(def.kind) &&
           (!is_thick(def.margin) || contains(table.box(object), world.exact_[index]));
  }
};

template <int D>
WorldStatus World<D>::save(std::vector<std::uint8_t>& bytes) const {
  if (unstepped_ || torn_) return WorldStatus::unstepped;
  bytes = WorldCodec<D>::encode(*this);
  return WorldStatus::ok;
}

template <int D>
WorldStatus World<D>::restore(std::span<const std::uint8_t> bytes, std::string* why) {
  if (is_asking_) {
    if (why != nullptr) *why = to_string(WorldStatus::busy);
    return WorldStatus::busy;
  }
  try {
    const DefaultFloats floats;
    World restored = WorldCodec<D>::decode(bytes);
    restored.set_threads(options_.threads, options_.sharing);
    restored.callback_ = std::move(callback_);
    *this = std::move(restored);
    return WorldStatus::ok;
  } catch (const Damage& damage) {
    if (why != nullptr) *why = "the bytes are no state of this world: " + damage.fault();
    return WorldStatus::damaged;
  }
}

#define KERF_INSTANTIATE(D)                                              \
  template WorldStatus World<D>::save(std::vector<std::uint8_t>&) const; \
  template WorldStatus World<D>::restore(std::span<const std::uint8_t>, std::string*);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf

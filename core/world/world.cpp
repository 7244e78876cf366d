#include "core/world/world.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/float_mode.h"
#include "core/world/world_boxes.h"

namespace kerf {
namespace {

constexpr bool is_kind(ObjectKind kind) { return static_cast<int>(kind) < kObjectKinds; }
constexpr Mobility mobility(ObjectKind kind) { return is_passive(kind) ? Mobility::fixed : Mobility::moving; }

/// Of a batch that the pair callback asks for.
WorldStatus refuse_all(std::span<WorldStatus> statuses) {
  std::ranges::fill(statuses, WorldStatus::busy);
  return WorldStatus::busy;
}

}  // namespace

/// The scope of a change of the tree, in which boxes are compared as they are. If it ends by an exception,
/// the tree is built anew before the next change.
template <int D>
class World<D>::Change {
 public:
  explicit Change(World& world) : world_(world) {
    if (world.torn_) world.rebuild();
    world.torn_ = true;
  }
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;
  ~Change() = default;
  void finish() { world_.torn_ = false; }

 private:
  UsualComparisons comparisons_;
  World& world_;
};

template <int D>
World<D>::World(const WorldOptions& options)
    : options_(options), tree_(std::make_unique<Bsp<D>>(options.config)), slots_(options.tag) {
  set_threads(options.threads, options.sharing);
}

/// For what returns no status.
template <int D>
void World<D>::throw_if_asking() const {
  if (is_asking_) throw std::logic_error(std::string(to_string(WorldStatus::busy)));
}

template <int D>
void World<D>::set_callback(PairCallback callback) {
  throw_if_asking();
  callback_ = std::move(callback);
}

template <int D>
void World<D>::set_threads(unsigned threads, Sharing sharing) {
  throw_if_asking();
  tree_->set_threads(threads, sharing);
  options_.threads = threads;
  options_.sharing = sharing;
}

/// All objects of the world go into a new tree. The box of an object that lives is in the old one's table,
/// whatever its state there. The dead come and go: a tree refuses an index without most of those below it.
template <int D>
void World<D>::rebuild() {
  auto tree = std::make_unique<Bsp<D>>(options_.config);
  tree->set_threads(options_.threads, options_.sharing);
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    const Box<D> box = slots_.is_alive(i) ? tree_->objects().box({i}) : Box<D>{};
    (void)tree->insert({i}, box, mobility(defs_[i].kind));
  }
  for (std::uint32_t i = 0; i < slots_.size(); ++i)
    if (!slots_.is_alive(i)) (void)tree->remove({i});
  tree_ = std::move(tree);
  torn_ = false;
  unstepped_ = true;
}

template <int D>
void World<D>::count(const ObjectDef& def, std::ptrdiff_t times) {
  if (is_thick(def.margin)) margins_ += times;
  if (def.filter != PairFilter{}) filters_ += times;
  if (def.kind == ObjectKind::sensor) sensors_ += times;
}

/// Makes the requests of a batch, and keeps and sums up their statuses.
template <int D>
template <class Request>
WorldStatus World<D>::for_each_of(std::size_t count, std::span<WorldStatus> statuses, Request request) {
  WorldStatus sum = WorldStatus::ok;
  for (std::size_t k = 0; k < count; ++k) {
    const WorldStatus status = request(k);
    if (!statuses.empty()) statuses[k] = status;
    if (!is_failure(sum) && status != WorldStatus::ok) sum = status;
  }
  return sum;
}

template <int D>
typename World<D>::Inserted World<D>::insert(const Box<D>& box, const ObjectDef& def) {
  if (is_asking_) return {WorldStatus::busy, {}};
  Change change(*this);
  Handle handle;
  const WorldStatus status = insert_one(box, def, handle);
  change.finish();
  return {status, handle};
}

template <int D>
WorldStatus World<D>::insert(std::span<const Box<D>> boxes, std::span<const ObjectDef> defs,
                             std::span<Handle> handles, std::span<WorldStatus> statuses) {
  if ((defs.size() != 1 && defs.size() != boxes.size()) || handles.size() != boxes.size() ||
      (!statuses.empty() && statuses.size() != boxes.size()))
    return WorldStatus::bad_length;
  std::ranges::fill(handles, Handle{});
  if (boxes.empty()) return WorldStatus::ok;
  if (is_asking_) return refuse_all(statuses);
  Change change(*this);
  const WorldStatus sum = for_each_of(boxes.size(), statuses, [&](std::size_t k) {
    return insert_one(boxes[k], defs[defs.size() == 1 ? 0 : k], handles[k]);
  });
  change.finish();
  return sum;
}

template <int D>
WorldStatus World<D>::insert_one(Box<D> box, const ObjectDef& def, Handle& handle) {
  if (!is_ordered(box)) return WorldStatus::bad_box;
  if (!is_kind(def.kind) || !is_margin(def.margin)) return WorldStatus::bad_value;
  const Handle next = slots_.peek();
  if (next.is_none()) return WorldStatus::full;
  const WorldStatus status = clamp(box);
  const ObjectId object{next.index()};
  if (defs_.size() <= object.index()) defs_.resize(object.index() + 1);
  if (is_thick(def.margin) && exact_.size() <= object.index()) exact_.resize(object.index() + 1);
  if (is_refused(tree_->insert(object, grow(box, def.margin), mobility(def.kind)))) return WorldStatus::full;
  if (is_thick(def.margin)) exact_[object.index()] = box;
  defs_[object.index()] = def;
  count(def, 1);
  slots_.take();
  unstepped_ = true;
  handle = next;
  return status;
}

template <int D>
WorldStatus World<D>::move(Handle object, const Box<D>& box) {
  return move({&object, 1}, {&box, 1});
}

template <int D>
WorldStatus World<D>::move(std::span<const Handle> objects, std::span<const Box<D>> boxes,
                           std::span<WorldStatus> statuses) {
  if (objects.size() != boxes.size() || (!statuses.empty() && statuses.size() != boxes.size()))
    return WorldStatus::bad_length;
  if (objects.empty()) return WorldStatus::ok;
  if (is_asking_) return refuse_all(statuses);
  Change change(*this);
  WorldStatus sum = WorldStatus::ok;
  if (list_moves(objects, boxes)) {
    const Status status = tree_->move_many(ids_, boxes);
    unstepped_ = true;
    if (status != Status::ok || !statuses.empty())
      sum = for_each_of(boxes.size(), statuses, [&](std::size_t k) {
        return is_valid(boxes[k]) ? WorldStatus::ok : WorldStatus::clamped;
      });
  } else {
    sum = for_each_of(boxes.size(), statuses, [&](std::size_t k) { return move_one(objects[k], boxes[k]); });
  }
  change.finish();
  return sum;
}

/// Lists the objects in `ids_`. False if a move cannot go to the tree as it is.
template <int D>
bool World<D>::list_moves(std::span<const Handle> objects, std::span<const Box<D>> boxes) {
  if (margins_ > 0) return false;
  ids_.resize(objects.size());
  bool all = true;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    ids_[k] = {objects[k].index()};
    all &= slots_.contains(objects[k]) & is_ordered(boxes[k]);
  }
  return all;
}

template <int D>
WorldStatus World<D>::move_one(Handle object, Box<D> box) {
  if (!slots_.contains(object)) return WorldStatus::stale_handle;
  if (!is_ordered(box)) return WorldStatus::bad_box;
  const WorldStatus status = clamp(box);
  const ObjectId id{object.index()};
  const Scalar margin = defs_[id.index()].margin;
  const bool stays = is_thick(margin) && kerf::contains(tree_->objects().box(id), box);
  if (!stays) (void)tree_->move(id, grow(box, margin));
  if (is_thick(margin)) exact_[id.index()] = box;
  unstepped_ = true;
  return status;
}

/// Moves the objects in `ids_` to `fat_boxes_`: all, or none where memory ends.
template <int D>
void World<D>::move_listed() {
  tree_->make_room_for_moves(ids_.size());
  Change change(*this);
  (void)tree_->move_many(ids_, fat_boxes_);
  unstepped_ |= !ids_.empty();
  change.finish();
}

template <int D>
WorldStatus World<D>::remove(Handle object) {
  return remove({&object, 1});
}

template <int D>
WorldStatus World<D>::remove(std::span<const Handle> objects, std::span<WorldStatus> statuses) {
  if (!statuses.empty() && statuses.size() != objects.size()) return WorldStatus::bad_length;
  if (objects.empty()) return WorldStatus::ok;
  if (is_asking_) return refuse_all(statuses);
  Change change(*this);
  const WorldStatus sum =
      for_each_of(objects.size(), statuses, [&](std::size_t k) { return remove_one(objects[k]); });
  change.finish();
  return sum;
}

template <int D>
WorldStatus World<D>::remove_one(Handle object) {
  if (!slots_.contains(object)) return WorldStatus::stale_handle;
  (void)tree_->remove({object.index()});
  count(defs_[object.index()], -1);
  slots_.release(object);
  unstepped_ = true;
  return WorldStatus::ok;
}

/// Whether a request about the object can be met.
template <int D>
WorldStatus World<D>::check(Handle object) const {
  if (is_asking_) return WorldStatus::busy;
  return slots_.contains(object) ? WorldStatus::ok : WorldStatus::stale_handle;
}

template <int D>
WorldStatus World<D>::set_kind(Handle object, ObjectKind kind) {
  if (const WorldStatus status = check(object); is_failure(status)) return status;
  if (!is_kind(kind)) return WorldStatus::bad_value;
  ObjectDef def = defs_[object.index()];
  Change change(*this);
  if (mobility(kind) != mobility(def.kind)) {
    const ObjectId id{object.index()};
    const Box<D> box = tree_->objects().box(id);
    (void)tree_->remove(id);
    (void)tree_->insert(id, box, mobility(kind));
  }
  count(def, -1);
  def.kind = kind;
  count(def, 1);
  defs_[object.index()] = def;
  unstepped_ = true;
  change.finish();
  return WorldStatus::ok;
}

template <int D>
WorldStatus World<D>::set_filter(Handle object, const PairFilter& filter) {
  if (const WorldStatus status = check(object); is_failure(status)) return status;
  ObjectDef& def = defs_[object.index()];
  unstepped_ = true;
  count(def, -1);
  def.filter = filter;
  count(def, 1);
  return WorldStatus::ok;
}

template <int D>
WorldStatus World<D>::set_user_data(Handle object, std::uint64_t user_data) {
  if (const WorldStatus status = check(object); is_failure(status)) return status;
  defs_[object.index()].user_data = user_data;
  return WorldStatus::ok;
}

template <int D>
WorldStatus World<D>::set_margin(Handle object, Scalar margin) {
  if (const WorldStatus status = check(object); is_failure(status)) return status;
  if (!is_margin(margin)) return WorldStatus::bad_value;
  ObjectDef& def = defs_[object.index()];
  const ObjectId id{object.index()};
  const Box<D> box = exact_box(id);
  Change change(*this);
  if (is_thick(margin) && exact_.size() <= id.index()) exact_.resize(id.index() + 1);
  (void)tree_->move(id, grow(box, margin));
  if (is_thick(margin)) exact_[id.index()] = box;
  count(def, -1);
  def.margin = margin;
  count(def, 1);
  unstepped_ = true;
  change.finish();
  return WorldStatus::ok;
}

template <int D>
const ObjectDef* World<D>::find(Handle object) const {
  return slots_.contains(object) ? &defs_[object.index()] : nullptr;
}

template <int D>
std::optional<Box<D>> World<D>::box(Handle object) const {
  if (!slots_.contains(object)) return std::nullopt;
  return exact_box({object.index()});
}

template <int D>
std::optional<Box<D>> World<D>::fat_box(Handle object) const {
  if (!slots_.contains(object)) return std::nullopt;
  return tree_->objects().box({object.index()});
}

template <int D>
void World<D>::step() {
  throw_if_asking();
  unstepped_ = true;  // also for the callback, and if memory ends
  {
    Change change(*this);
    tree_->step();
    change.finish();
  }
  gather();
  report();
  slots_.finish_step();
  unstepped_ = false;
}

template class World<2>;
template class World<3>;

}  // namespace kerf

#include "tests/fuzz/tree/operator_machine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/tree/balance.h"
#include "core/tree/criteria.h"
#include "core/tree/hash.h"
#include "core/tree/merge.h"
#include "core/tree/placement.h"
#include "core/tree/shed.h"
#include "core/tree/shift_split.h"
#include "core/tree/split.h"
#include "core/tree/swap.h"
#include "core/tree/validate.h"
#include "tests/fuzz/tree/config_reader.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kObjects = 40;
constexpr std::uint64_t kMaxEntries = 1500;

/// A few direction sets, made once: one for a DOP takes longer than a case.
template <int D>
std::shared_ptr<const Projector<D>> projector(VolumeKind kind, std::uint32_t choice) {
  constexpr std::uint32_t kSets = 4;
  using Sets = std::array<std::shared_ptr<const Projector<D>>, kSets>;
  static std::array<Sets, 8> made;
  auto& place = made[static_cast<std::size_t>(kind)][choice % kSets];
  if (place != nullptr) return place;
  Random random(choice % kSets);
  DirectionSet<D> set =
      choice % kSets == 0 ? DirectionSet<D>(12, 1) : DirectionSet<D>(hard_directions<D>(10, random));
  place = std::make_shared<const Projector<D>>(std::move(set), kind);
  return place;
}

template <int D>
void run_kind(ByteReader& bytes, MachineReport& report) {
  const auto kinds = volume_kinds<D>();
  OperatorMachine<D>(kinds[bytes.below(static_cast<std::uint32_t>(kinds.size()))], bytes, report).run();
}

}  // namespace

void run_operator_case(CaseBytes bytes, MachineReport& report) {
  ByteReader reader(bytes);
  ++report.cases;
  report.finding.clear();
  if (reader.below(2) == 0)
    run_kind<2>(reader, report);
  else
    run_kind<3>(reader, report);
}

std::string operators_case(CaseBytes bytes) {
  MachineReport report;
  run_operator_case(bytes, report);
  return report.finding;
}

template <int D>
OperatorMachine<D>::OperatorMachine(VolumeKind kind, ByteReader& bytes, MachineReport& report)
    : bytes_(bytes),
      report_(report),
      volumes_(kind, bytes),
      tree_(projector<D>(kind, bytes.byte())),
      latest_(kind),
      config_(small_tree_config()) {}

template <int D>
void OperatorMachine<D>::run() {
  while (!bytes_.is_spent() && report_.finding.empty()) operate();
}

template <int D>
void OperatorMachine<D>::operate() {
  const std::uint8_t code = bytes_.byte();
  const bool sorts = code < 224;  // else the next operation finds lists out of order, as within a step
  const int what = code % 29;
  if (what < 5)
    insert();
  else if (what < 9)
    move();
  else if (what < 10)
    move_many();
  else if (what < 12)
    remove();
  else if (what < 15)
    divide_leaf(Operator::split);
  else if (what < 17)
    divide_leaf(Operator::shift_split);
  else if (what < 19)
    change_inner(Operator::balance);
  else if (what < 21)
    change_inner(Operator::swap);
  else if (what < 22)
    change_inner(Operator::merge);
  else if (what < 24)
    plant_plane();
  else if (what < 25)
    schedule(true);
  else if (what < 27)
    schedule(false);
  else if (what < 28)
    change_config();
  else
    shed();
  if (report_.finding.empty()) check(sorts);
}

template <int D>
void OperatorMachine<D>::insert() {
  last_ = "insert";
  ++report_.requests;
  const ObjectId object{bytes_.below(kObjects)};
  const Mobility mobility = bytes_.below(8) == 0 ? Mobility::fixed : Mobility::moving;
  const bool fresh = latest_.state(object) == ObjectState::absent;
  const Status status = latest_.insert(object, volumes_.read(), mobility);
  if ((status == Status::duplicate_id) == fresh) find("status of insert");
  if (fresh) take_over({object});
}

template <int D>
void OperatorMachine<D>::move() {
  last_ = "move";
  ++report_.requests;
  const ObjectId object{bytes_.below(kObjects)};
  if (latest_.move(object, volumes_.read()) != Status::unknown_id) take_over({object});
}

template <int D>
void OperatorMachine<D>::move_many() {
  last_ = "move of many";
  std::vector<ObjectId> moved;
  const std::uint32_t count = 2 + bytes_.below(8);
  const std::uint32_t first = bytes_.below(kObjects);
  for (std::uint32_t i = 0; i < count; ++i) {
    ++report_.requests;
    const ObjectId object{(first + i) % kObjects};
    if (latest_.move(object, volumes_.read()) != Status::unknown_id) moved.push_back(object);
  }
  take_over(moved);
}

template <int D>
void OperatorMachine<D>::remove() {
  last_ = "remove";
  ++report_.requests;
  const ObjectId object{bytes_.below(kObjects)};
  if (latest_.remove(object) == Status::ok) take_over({object});
}

/// What a step does with its changes: an object that stays in its leaves has its keys renewed, the others are
/// taken out and placed again.
template <int D>
void OperatorMachine<D>::take_over(const std::vector<ObjectId>& changed) {
  moved_ = true;
  bool any_stays = false;
  std::vector<ObjectId> leaving;
  std::vector<ObjectId> entering;
  for (const ObjectId object : changed) {
    const bool was = tree_.table.is_placed(object);
    const bool is = latest_.is_placed(object);
    const bool same_leaves = was && is && try_keep_in_leaves(tree_, object, latest_.volume(object));
    any_stays |= same_leaves;
    if (was && !same_leaves) leaving.push_back(object);
    if (is && !same_leaves) entering.push_back(object);
  }
  displace<D>(tree_, tree_.root(), leaving);
  for (const ObjectId object : changed) tree_.table.copy(latest_, object);
  for (const ObjectId object : entering) place(tree_, tree_.root(), object, 0);
  if (any_stays) sort_phase(tree_);  // until then the keys of those that stay are old
}

template <int D>
void OperatorMachine<D>::divide_leaf(Operator op) {
  last_ = to_string(op);
  const NodeId leaf = pick(true);
  const std::uint64_t before = hash(tree_);
  Refusal refusal{};
  const auto event = op == Operator::split ? split(tree_, leaf, config_, refusal)
                                           : shift_split(tree_, leaf, config_, refusal);
  if (!event) return refused_without_trace(before, op);
  expect_event(*event);
  if (tree_[leaf].is_leaf() || !is_good(quality(tree_, leaf), config_at(tree_, leaf, config_)))
    find("a division that is not good");
}

template <int D>
void OperatorMachine<D>::change_inner(Operator op) {
  last_ = to_string(op);
  const NodeId inner = pick(false);
  if (inner.is_none()) return;
  if (op == Operator::balance) {
    const std::uint64_t before = hash(tree_);
    Refusal refusal{};
    const auto event = balance(tree_, inner, config_, refusal);
    if (!event) return refused_without_trace(before, op);
    expect_event(*event);
    if (!is_good(quality(tree_, inner), config_at(tree_, inner, config_)))
      find("a balanced node that is not good");
    return;
  }
  const NodeRef ref = tree_.ref(inner);
  expect_event(op == Operator::merge ? merge(tree_, inner) : swap(tree_, inner));
  if (tree_.is_alive(ref) != (op == Operator::merge)) find("the wrong node is dead");
}

template <int D>
void OperatorMachine<D>::plant_plane() {
  last_ = "planted plane";
  const NodeId leaf = pick(true);
  const std::vector<Entry>& entries = tree_[leaf].entries;
  const std::uint32_t direction = bytes_.below(tree_.directions().size());
  const std::uint32_t end = bytes_.below(4);
  if (entries.empty() || tree_[leaf].depth >= kMaxHeight || tree_.entries() > kMaxEntries) return;
  const ObjectId object = entries[bytes_.below(static_cast<std::uint32_t>(entries.size()))].object;
  const Interval shadow = tree_.project(direction, object);
  Scalar offset = end % 2 == 0 ? shadow.lo : shadow.hi;
  if (end >= 2) offset = std::nextafter(offset, std::numeric_limits<Scalar>::lowest());
  if (std::isfinite(offset)) divide(tree_, leaf, direction, offset);
}

template <int D>
void OperatorMachine<D>::schedule(bool traverse) {
  last_ = traverse ? "traverse" : "process";
  ++report_.requests;
  const auto acted = scheduler_.acted();
  const std::uint64_t refused = scheduler_.refused();
  if (traverse) {
    // Operators that Algorithm 1 calls find sorted lists.
    sort_phase(tree_);
    scheduler_.traverse(tree_, config_, ++step_, reporter_);
  } else {
    scheduler_.process(tree_, config_, step_, reporter_);
  }
  for (std::size_t op = 0; op < acted.size(); ++op) report_.acted[op] += scheduler_.acted()[op] - acted[op];
  report_.refused += scheduler_.refused() - refused;
}

template <int D>
void OperatorMachine<D>::change_config() {
  last_ = "parameter change";
  ++report_.requests;
  change_parameter(config_, bytes_);
}

template <int D>
void OperatorMachine<D>::shed() {
  last_ = "shedding of entries";
  Config tight = config_;  // few sequences reach twice the usual limit
  tight.max_entries = 1 + 0.25F * static_cast<float>(bytes_.below(8));
  const std::vector<OperatorActed> events = shed_entries(tree_, tight);
  for (const OperatorActed& event : events) expect_event(event);
  const double limit = static_cast<double>(tight.max_entries) * tree_.objects();
  if (static_cast<double>(tree_.entries()) > (events.empty() ? 2 * limit : limit))
    find("too many entries are left");
}

template <int D>
void OperatorMachine<D>::refused_without_trace(std::uint64_t hash_before, Operator op) {
  ++report_.refused;
  if (hash(tree_) != hash_before) find("a refused " + std::string(to_string(op)) + " changed the tree");
}

template <int D>
void OperatorMachine<D>::expect_event(const OperatorActed& event) {
  ++report_.acted[static_cast<std::size_t>(event.op)];
  if (event.op == Operator::swap || event.op == Operator::merge) return;
  if (!(event.after == quality(tree_, event.node.node))) find("the event has another quality than the tree");
}

template <int D>
void OperatorMachine<D>::check(bool sorts) {
  ++report_.validations;
  for (const Violation& violation : validate(tree_)) find(violation.what);
  if (sorts && report_.finding.empty()) compare_pairs();
}

template <int D>
void OperatorMachine<D>::compare_pairs() {
  const std::vector<Pair> found = sorted(swept(tree_));
  if (moved_) {
    expected_.clear();
    for (std::uint32_t a = 0; a < latest_.bound(); ++a)
      for (std::uint32_t b = a + 1; b < latest_.bound(); ++b)
        if (latest_.is_placed({a}) && latest_.is_placed({b}) && latest_.is_pair({a}, {b}))
          expected_.push_back({{a}, {b}});
  }
  moved_ = false;
  ++report_.comparisons;
  report_.pairs += expected_.size();
  if (found != expected_) find(difference(found, expected_));
}

/// A leaf, or an inner node; none if there is no inner node.
template <int D>
NodeId OperatorMachine<D>::pick(bool leaf) {
  std::vector<NodeId> nodes;
  for_each_node(tree_, tree_.root(), [&](NodeId id) {
    if (tree_[id].is_leaf() == leaf) nodes.push_back(id);
  });
  const std::uint32_t choice = bytes_.byte();
  return nodes.empty() ? NodeId::none() : nodes[choice % nodes.size()];
}

template <int D>
void OperatorMachine<D>::find(const std::string& what) {
  if (report_.finding.empty())
    report_.finding =
        std::to_string(D) + "D " + std::string(to_string(latest_.kind())) + ", after " + last_ + ": " + what;
}

template class OperatorMachine<2>;
template class OperatorMachine<3>;

}  // namespace kerf::test

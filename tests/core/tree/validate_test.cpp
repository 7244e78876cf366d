#include "core/tree/validate.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

using testing::IsEmpty;

/// A sound tree: plane 0 at the root, one more below each of its children; object 0 straddles the root's
/// plane.
template <int D>
kerf::Tree<D> sound_tree() {
  Random random(1);
  std::vector<Box<D>> boxes{slab<D>(4, 16)};
  for (int k = 0; k < 30; ++k) boxes.push_back(random_box<D>(random, 20, 1));
  auto tree = tree_of<D>(boxes);
  plant(tree, tree.root(), 0, 10);
  plant(tree, tree[tree.root()].left, 1, 10);
  plant(tree, tree[tree.root()].right, 1, 10);
  return tree;
}

template <class T>
class Validate : public testing::Test {
 protected:
  static constexpr int kSize = T::value;
  using Node = kerf::Node<kSize>;

  Validate() : tree(sound_tree<kSize>()), left(tree[tree.root()].left), leaf(tree[left].left) {}

  Node& root_node() { return tree[tree.root()]; }
  Node& left_node() { return tree[left]; }
  Node& leaf_node() { return tree[leaf]; }
  /// The entry of object 0, which straddles, in the first leaf that has it.
  Entry& straddler() {
    for (NodeId id : {tree[left].left, tree[left].right})
      for (Entry& entry : tree[id].entries)
        if (entry.object.value == 0) return entry;
    throw std::logic_error("object 0 is not left of the root's plane");
  }

  /// Expects that the damage is reported at `where`, in these words.
  void expect_reported(const std::string& what, NodeId where) {
    std::string all;
    for (const Violation& violation : validate(tree)) {
      if (violation.what == what && violation.node == where) return;
      all += "\n" + std::to_string(violation.node.value) + ": " + violation.what;
    }
    ADD_FAILURE() << "not reported: " << where.value << ": " << what << all;
  }

  kerf::Tree<kSize> tree;
  NodeId left;  ///< an inner node below the root
  NodeId leaf;  ///< a leaf below that
};
TYPED_TEST_SUITE(Validate, Dimensions, DimensionNames);

TYPED_TEST(Validate, FindsNothingWrongWithASoundTree) { EXPECT_THAT(validate(this->tree), IsEmpty()); }

TYPED_TEST(Validate, FindsNothingWrongWithAnEmptyTree) {
  constexpr int kD = TypeParam::value;
  EXPECT_THAT(validate(tree_of<kD>(std::vector<Box<kD>>{})), IsEmpty());
}

TYPED_TEST(Validate, ReportsARootBelowSomething) {
  this->root_node().parent = this->leaf;
  this->expect_reported("the root has a parent", this->tree.root());
}

TYPED_TEST(Validate, ReportsARootAtDepth) {
  this->root_node().depth = 1;
  this->expect_reported("the root is not at depth 0", this->tree.root());
}

TYPED_TEST(Validate, ReportsALinkOutside) {
  this->root_node().right = NodeId{1000};
  this->expect_reported("a link leads outside or to a node that is reached already", {1000});
}

TYPED_TEST(Validate, ReportsALoop) {
  this->left_node().left = this->tree.root();
  this->expect_reported("a link leads outside or to a node that is reached already", this->tree.root());
}

TYPED_TEST(Validate, ReportsALivingNodeThatNoLinkReaches) {
  const NodeId lost = this->tree.make_leaf(NodeId::none(), false, 0);
  this->expect_reported("a node is alive but not reached, or reached but dead", lost);
}

TYPED_TEST(Validate, ReportsADeadNodeThatIsReached) {
  this->leaf_node().alive = false;
  this->expect_reported("a node is alive but not reached, or reached but dead", this->leaf);
}

TYPED_TEST(Validate, ReportsANodeWithOneChild) {
  this->left_node().right = NodeId::none();
  this->expect_reported("a node has one child", this->left);
}

TYPED_TEST(Validate, ReportsADirectionOutsideTheSet) {
  this->leaf_node().direction = 10'000;
  this->expect_reported("the direction is not in the set", this->leaf);
  this->left_node().direction = 10'000;
  this->expect_reported("the direction is not in the set", this->left);
}

TYPED_TEST(Validate, ReportsANodeDeeperThanMasks) {
  for (const NodeId id : {this->leaf, this->left}) {
    this->tree[id].depth = kMaxHeight + 1;
    this->expect_reported("the node is deeper than a mask has bits", id);
  }
}

TYPED_TEST(Validate, ReportsEntriesOfAnInnerNode) {
  this->left_node().entries.push_back(this->straddler());
  this->expect_reported("an inner node has entries", this->left);
}

TYPED_TEST(Validate, ReportsAnOffsetThatIsNotFinite) {
  for (const Scalar offset :
       {std::numeric_limits<Scalar>::infinity(), std::numeric_limits<Scalar>::quiet_NaN()}) {
    this->left_node().plane.offset = offset;
    this->expect_reported("the offset is not finite", this->left);
  }
}

TYPED_TEST(Validate, ReportsANormalOfAnotherDirection) {
  this->left_node().plane.normal = this->tree.directions()[0];
  this->expect_reported("the normal is not its direction's", this->left);
}

TYPED_TEST(Validate, ReportsAWrongParent) {
  this->leaf_node().parent = this->tree.root();
  this->expect_reported("the parent link is wrong", this->leaf);
}

TYPED_TEST(Validate, ReportsAWrongDepth) {
  this->leaf_node().depth = 1;
  this->expect_reported("the depth is not the parent's plus one", this->leaf);
}

TYPED_TEST(Validate, ReportsAWrongRightOfMask) {
  this->leaf_node().right_of ^= 1U;
  this->expect_reported("the right-of mask is wrong", this->leaf);
}

TYPED_TEST(Validate, ReportsAListAlongAnotherNormal) {
  this->leaf_node().direction = 0;
  this->expect_reported("the list is not along the parent's normal", this->leaf);
}

TYPED_TEST(Validate, ReportsAnEntryOfAnAbsentOrQuarantinedObject) {
  constexpr int kD = TypeParam::value;
  const ObjectId object = this->leaf_node().entries.front().object;
  const Box<kD> box = this->tree.table.box(object);
  ASSERT_EQ(this->tree.table.move(object, Box<kD>{box.max + all<kD>(1), box.min}), Status::quarantined);
  this->expect_reported("an entry's object is absent or quarantined", this->leaf);
  ASSERT_EQ(this->tree.table.remove(object), Status::ok);
  this->expect_reported("an entry's object is absent or quarantined", this->leaf);
}

TYPED_TEST(Validate, ReportsAStaleKey) {
  const Scalar hi = this->leaf_node().entries.front().key.hi;
  this->leaf_node().entries.front().key.hi = std::nextafter(hi, 100.0F);
  this->expect_reported("an entry's key is not its projection", this->leaf);
}

TYPED_TEST(Validate, ReportsABoxThatChangedBehindItsBack) {
  constexpr int kD = TypeParam::value;
  const ObjectId object = this->leaf_node().entries.front().object;
  ASSERT_EQ(this->tree.table.move(object, box_at(all<kD>(19), 0.5F)), Status::ok);
  this->expect_reported("an entry's key is not its projection", this->leaf);
}

TYPED_TEST(Validate, ReportsAnObjectWithTwoEntries) {
  this->leaf_node().entries.push_back(this->leaf_node().entries.back());
  this->expect_reported("an object has two entries", this->leaf);
}

TYPED_TEST(Validate, ReportsAListOutOfOrderUnlessItIsToBeSorted) {
  std::reverse(this->leaf_node().entries.begin(), this->leaf_node().entries.end());
  this->expect_reported("the list is out of order", this->leaf);
  this->leaf_node().unsorted = true;
  EXPECT_THAT(validate(this->tree), IsEmpty());
}

TYPED_TEST(Validate, ReportsTiesThatAreNotOrderedByObject) {
  constexpr int kD = TypeParam::value;
  auto ties = tree_of<kD>(std::vector(3, slab<kD>(0, 1)));
  std::swap(ties[ties.root()].entries[0], ties[ties.root()].entries[2]);
  const auto violations = validate(ties);
  ASSERT_FALSE(violations.empty());
  EXPECT_EQ(violations.front().what, "the list is out of order");
}

TYPED_TEST(Validate, ReportsAMissingObject) {
  this->leaf_node().entries.pop_back();
  this->expect_reported("an object is missing here, or its straddle mask is wrong", this->leaf);
  this->expect_reported("the count of entries is wrong", NodeId::none());
}

TYPED_TEST(Validate, ReportsAWrongStraddleMask) {
  Entry& entry = this->straddler();
  ASSERT_NE(DepthMask{entry.straddle}, 0U);
  const DepthMask right = entry.straddle;
  const std::size_t before = validate(this->tree).size();
  for (const DepthMask wrong : {DepthMask{0}, right ^ 0b10U, right | depth_bit(40)}) {
    entry.straddle = wrong;
    EXPECT_GT(validate(this->tree).size(), before) << wrong;
  }
}

TYPED_TEST(Validate, ReportsAnEntryWhereTheObjectDoesNotBelong) {
  const NodeId other = this->tree[this->left].right;
  for (const Entry& entry : this->leaf_node().entries) {
    const auto& there = this->tree[other].entries;
    const auto same = [&](const Entry& e) { return e.object == entry.object; };
    if (std::any_of(there.begin(), there.end(), same)) continue;
    this->tree.add_entry(other, entry.object, entry.straddle);
    break;
  }
  this->expect_reported("there are entries where no object belongs", NodeId::none());
}

TYPED_TEST(Validate, ReportsAWrongPopulation) {
  for (const NodeId id : {this->tree.root(), this->left, this->leaf}) {
    ++this->tree[id].population;
    this->expect_reported("the population is wrong", id);
    --this->tree[id].population;
  }
}

TYPED_TEST(Validate, ReportsAPlaneThatMovedWithoutItsObjects) {
  this->root_node().plane.offset = 5;
  EXPECT_FALSE(validate(this->tree).empty());
}

}  // namespace
}  // namespace kerf::test

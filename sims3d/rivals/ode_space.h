#pragma once

#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/objects/structure.h"
#include "sims3d/ode_library.h"

namespace kerf {

/// ODE's own broad phases, as the paper compares them (section 6.1), and its later sweep-and-prune.
enum class OdeSpaceKind : std::uint8_t { hash, quadtree, sweep_and_prune };

/// Which boxes the space gets.
enum class OdeIntake : std::uint8_t {
  checked,  ///< as ObjectTable has them: without quarantined objects, infinities clamped
  raw,      ///< as given, so that a test shows how ODE handles NaN and the like
};

/// The plane that the quadtree divides.
enum class OdePlane : std::uint8_t {
  xz,  ///< level ground where Y is up, as in the paper (section 6.1)
  xy,  ///< for boxes of two dimensions
};

/// One of ODE's spaces behind our interface: the rival. Each object is a box geom in the space.
///
/// The space has the boxes in doubles. Category bits exclude pairs of two fixed objects. ODE's quadtree
/// divides its X and Y, so that it gets boxes with Y and Z exchanged where the plane is another.
class OdeSpace final : public BroadPhase<3>, public SelfDescribing<3> {
 public:
  /// `bounds` is where the quadtree lies; objects outside are kept in its root. The other kinds do not need
  /// it. Throws std::runtime_error if ODE cannot make the space.
  OdeSpace(OdeSpaceKind kind, const Box<3>& bounds, OdeIntake intake = OdeIntake::checked,
           OdePlane plane = OdePlane::xz);
  ~OdeSpace() override;

  [[nodiscard]] std::string_view name() const override;
  Status insert(ObjectId object, const Box<3>& box, Mobility mobility) override;
  Status move(ObjectId object, const Box<3>& box) override;
  Status remove(ObjectId object) override;
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }
  /// The seconds that the last `step()` took to bring the structure up to date: the quadtree, or the hash
  /// table after `separate_times()`. The other spaces do so while they search for pairs, and return 0.
  [[nodiscard]] double arrange_seconds() const { return arrange_seconds_; }
  /// Of a hash space: from now on the building and clearing of its table are measured apart from the search.
  /// Two pairs of geoms of our own say when the search begins and ends: ODE compares the one first, the other
  /// last. No object may come near 1e7 along X.
  void separate_times();
  /// How many pairs of boxes a `step()` compares with the objects where they are; negative: unknown. Builds a
  /// second space for it.
  [[nodiscard]] double count_candidates() const;
  /// ODE's headers show nothing of its spaces; only the number of tests is known.
  void describe(StructureParts<3>& parts) const override;

 private:
  void place(ObjectId object, const Box<3>& given);
  void arrange();
  void add_marker(double x, double size);
  void search();
  [[nodiscard]] dSpaceID make_space() const;

  OdeLibrary library_;  // first: everything below ends before it does
  OdeSpaceKind kind_;
  OdeIntake intake_;
  bool exchanges_axes_;  ///< Y and Z
  Box<3> bounds_;        ///< of the quadtree, as ODE has it
  ObjectTable<3> objects_;
  dSpaceID space_;
  std::vector<OdeHandle<dxGeom>> geoms_;
  OdeHandle<dxGeom> stranger_;  ///< far away and in no space
  std::vector<OdeHandle<dxGeom>> markers_;
  double arrange_seconds_ = 0;
  std::vector<Pair> pairs_;
};

}  // namespace kerf

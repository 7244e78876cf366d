#pragma once

#include <box2d/b2_world_callbacks.h>

#include <span>
#include <vector>

#include "core/base/ids.h"

class b2Body;
class b2Contact;
class b2ContactManager;
class b2World;

namespace kerf::inline sims2d {

/// Makes Box2D's contacts those of a given list of pairs, and no others.
///
/// Box2D 2.4 has no switch for another broad phase, so the gate controls its contact manager from outside: as
/// the world's contact filter it refuses everything that Box2D finds by itself, and opens only for its own
/// calls of AddPair. Bodies carry their ObjectId as user data and have one fixture with one child.
class ContactGate final : private b2ContactFilter {
 public:
  /// Becomes the filter of `world`, which must outlive the last call of `admit` only.
  explicit ContactGate(b2World& world);
  ContactGate(const ContactGate&) = delete;
  ContactGate& operator=(const ContactGate&) = delete;

  /// Destroys contacts without a pair, and creates one for each pair without a contact. `pairs` must be
  /// sorted, since the order of creation decides the order in which the solver works. `bodies` is indexed by
  /// object.
  void admit(std::span<const Pair> pairs, std::span<b2Body* const> bodies);

 private:
  struct Standing {
    Pair pair;
    b2Contact* contact;
  };

  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override;
  void list_standing();

  b2World& world_;
  b2ContactManager& manager_;
  std::vector<Standing> standing_;
  bool open_ = false;
};

}  // namespace kerf::inline sims2d

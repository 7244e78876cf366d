#pragma once

#include <set>
#include <vector>

#include "core/base/ids.h"

class b2World;

namespace kerf::test {

/// What Box2D finds with its own broad phase.
struct Reference {
  std::set<Pair> touching;
  std::vector<bool> awake;  ///< by object: can move and does not sleep
};

/// Builds a second world with the same bodies at the same poses, bit by bit, and the filter that Box2D has by
/// itself, and lets it find its contacts. Nothing of the first world's contacts or proxies is used.
Reference box2d_contacts(const b2World& world);

}  // namespace kerf::test

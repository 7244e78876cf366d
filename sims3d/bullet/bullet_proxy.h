#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/world/handle.h"
#include "core/world/world.h"

namespace kerf {

struct BulletProxy final : btBroadphaseProxy {
  using btBroadphaseProxy::btBroadphaseProxy;
  Handle handle;  ///< none: made with a box that is none, and never given another
};

using BulletProxies = std::vector<std::unique_ptr<BulletProxy>>;

inline auto find_proxy(BulletProxies& proxies, const btBroadphaseProxy* proxy) {
  return std::ranges::find(proxies, proxy, [](const auto& one) { return one.get(); });
}

inline ObjectKind kind_of(const btBroadphaseProxy& proxy) {
  constexpr int kStatic = btBroadphaseProxy::StaticFilter;
  const bool is_static =
      proxy.m_collisionFilterGroup == kStatic && (proxy.m_collisionFilterMask & kStatic) == 0;
  return is_static ? ObjectKind::fixed : ObjectKind::moving;
}

}  // namespace kerf

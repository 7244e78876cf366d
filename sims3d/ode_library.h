#pragma once

#include <ode/ode.h>

#include <memory>
#include <mutex>

namespace kerf {

/// ODE's process-wide state: the first living object initialises it, the last one closes it.
///
/// ODE's errors and failed assertions become std::runtime_error instead of an exit of the process; its
/// warnings go to the standard error stream as before.
class OdeLibrary {
 public:
  /// Throws std::runtime_error when ODE cannot be initialised, or is not the double-precision build.
  OdeLibrary();
  OdeLibrary(const OdeLibrary&) = delete;
  OdeLibrary& operator=(const OdeLibrary&) = delete;
  ~OdeLibrary();

  /// Every call into ODE needs this lock. Debian's build has no thread-local storage: all worlds share its
  /// random seed and the caches of its mesh collider. Recursive, because a world steps its broad phase while
  /// it works, and the rivals are spaces of ODE.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> enter() const;

  /// A geom in no space with these bounds (min and max of x, y and z), which collides with nothing.
  [[nodiscard]] dGeomID make_open_geom(const dReal* bounds) const;
  /// The six numbers of ODE's own that are its box, once a space has computed it.
  [[nodiscard]] static dReal* bounds_of(dGeomID open_geom);
};

/// Destroys an object of ODE's; null handles are never passed on.
struct OdeDeleter {
  void operator()(dWorldID world) const { dWorldDestroy(world); }
  void operator()(dBodyID body) const { dBodyDestroy(body); }
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
  void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
};

/// The one owner of an object of ODE's, for example OdeHandle<dxBody>.
template <class T>
using OdeHandle = std::unique_ptr<T, OdeDeleter>;

}  // namespace kerf

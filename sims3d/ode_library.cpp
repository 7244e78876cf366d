#include "sims3d/ode_library.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

static_assert(sizeof(dReal) == sizeof(double), "Kerf needs the double-precision build of ODE");

std::recursive_mutex library_mutex;
std::size_t users = 0;

/// ODE requires that its handlers do not return: unwinding is the only way out that leaves the process alive.
[[noreturn]] void throw_ode_error(int number, const char* format, va_list arguments) {
  std::array<char, 512> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw std::runtime_error("ODE reports error " + std::to_string(number) + ": " + text.data());
}

int open_class = 0;  ///< of geoms; ODE forgets it when it is closed

struct OpenGeomData {
  std::array<dReal, 6> given;
  dReal* bounds;
};

OpenGeomData& data_of(dGeomID geom) { return *static_cast<OpenGeomData*>(dGeomGetClassData(geom)); }

void place_open_geom(dGeomID geom, dReal bounds[6]) {
  std::ranges::copy(data_of(geom).given, bounds);
  data_of(geom).bounds = bounds;
}

dColliderFn* no_collider(int /*other_class*/) { return nullptr; }

void open_library() {
  if (dInitODE2(0) == 0) throw std::runtime_error("ODE cannot be initialised");
  if (dCheckConfiguration("ODE_double_precision") == 0) {
    dCloseODE();
    throw std::runtime_error(
        "ODE was built in single precision; Kerf needs Debian's double-precision libode");
  }
  dSetErrorHandler(throw_ode_error);
  dSetDebugHandler(throw_ode_error);
  const dGeomClass open{sizeof(OpenGeomData), no_collider, place_open_geom, nullptr, nullptr};
  open_class = dCreateGeomClass(&open);
}

}  // namespace

OdeLibrary::OdeLibrary() {
  const std::lock_guard lock(library_mutex);
  if (users == 0) open_library();
  ++users;
}

OdeLibrary::~OdeLibrary() {
  const std::lock_guard lock(library_mutex);
  if (--users > 0) return;
  dSetErrorHandler(nullptr);
  dSetDebugHandler(nullptr);
  dCloseODE();
}

std::unique_lock<std::recursive_mutex> OdeLibrary::enter() const {
  std::unique_lock lock(library_mutex);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
  return lock;
}

dGeomID OdeLibrary::make_open_geom(const dReal* bounds) const {
  const auto lock = enter();
  const dGeomID geom = dCreateGeom(open_class);
  std::copy_n(bounds, 6, data_of(geom).given.begin());
  return geom;
}

dReal* OdeLibrary::bounds_of(dGeomID open_geom) { return data_of(open_geom).bounds; }

}  // namespace kerf

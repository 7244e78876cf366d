#pragma once

#include "core/geometry/box.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"
#include "sims3d/ode_library.h"

namespace kerf {

/// A shape for ODE's narrow phase. It belongs to no space of ODE's. A surface keeps its mesh data here and
/// reads the vertices of the `Surface` in place, so that the shape has to outlive it.
struct Geom {
  OdeHandle<dxTriMeshData>
      mesh;  ///< null unless the shape is a surface; declared first: it outlives the geom
  OdeHandle<dxGeom> geom;
};

/// Throws std::invalid_argument, saying what is wrong, if the shape has no finite positive size or a surface
/// names a vertex that does not exist.
Geom make_geom(const Shape<3>& shape);

/// The mass of a ball or brick of the given density around its centre. Throws std::invalid_argument for a
/// surface: it has no inside.
dMass make_mass(const Shape<3>& shape, double density);

/// The volume of the given kind around the geom at its present pose, rounded outward; `shape` is the geom's
/// own.
Volume<3> outward_volume(VolumeKind kind, const Shape<3>& shape, dGeomID geom);

/// The geom's present pose, rounded to nearest.
Pose<3> pose_of(dGeomID geom);

}  // namespace kerf

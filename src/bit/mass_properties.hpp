#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Mass, centre of mass and inertia tensor of a solid, in one frame. The tensor is about the centre
/// of mass, along the axes of that frame.
struct MassProperties {
  double mass = 0.0;            ///< kg
  Vec3 centre = Vec3::Zero();   ///< m
  Mat3 inertia = Mat3::Zero();  ///< kg m2
};

/// Computes the mass properties of the solid inside a closed mesh, in the mesh's frame, by exact
/// integration over signed tetrahedra. `density` in kg/m3. Requires outward normals and a nonzero
/// volume. Not in the thesis.
MassProperties mass_properties(const mesh::TriangleMesh& m, double density);

/// The same body in frame A.
MassProperties transformed(const MassProperties& body_P, const Pose& X_AP);

/// The mass properties of two bodies in one frame taken together, by the parallel-axis theorem. A
/// massless body has no effect.
MassProperties combined(const MassProperties& a, const MassProperties& b);

/// The mass properties of a bit, in the bit frame: the sum over its parts with density > 0.
/// Overlaps count twice.
MassProperties mass_properties(const Bit& bit);

}  // namespace tdbd::bit

#pragma once

#include "reference/dynamics/lumped_drilling.hpp"
#include "reference/simulation/crushing_feet.hpp"

namespace tdbd::reference {

/// The part of a sphere in contact with flat rock that it has not cut before.
struct SphereContact {
  double area = 0.0;                  ///< m2, of its surface
  Vec3 area_vector_W = Vec3::Zero();  ///< m2, into the rock
  Vec3 middle_W = Vec3::Zero();       ///< m, centroid of the area, from the sphere's centre
};

/// Computes the contact of a sphere whose lowest point is `depth` (m) below flat rock and which
/// moves at v_W: its surface below the plane, where that moves into the rock. On a ring at the
/// angle a from the lowest point, that is where the azimuth relative to the motion is at most
/// acos(-v_z cos a / (v_h sin a)). The sum over the rings has `rings` equal parts.
SphereContact sphere_contact(double radius, double depth, const Vec3& v_W, int rings);

/// One spherical tooth of a bit that crushes flat rock at z = 0, forces (4) and (12).
struct SphericalTooth {
  Vec3 centre_B = Vec3::Zero();  ///< m
  double radius = 0.0;           ///< m
  double pressure = 0.0;         ///< Pa, normal force over the magnitude of the area vector
  SmoothContact contact;
  int rings = 100;
};

/// Its force as the law of a lumped bit. Valid as long as its path does not return to rock that it
/// has cut.
LumpedLaw law_of_tooth(const SphericalTooth& tooth);

}  // namespace tdbd::reference

#pragma once

#include <vector>

#include "core/types.hpp"
#include "reference/literature/surface/spoke_plane.hpp"

namespace tdbd::reference {

/// The hole's wall for models on spokes: a radius in the plane of each spoke.
struct SpokeWall {
  std::vector<double> radius;  ///< m
  std::vector<SpokePlane> planes;
};

SpokeWall round_wall(int spokes, double radius);

/// A wall's spring. Langeveld: restitution 1. Hanson and Hansen: contact loses energy (stated in
/// the thesis, 2.1); reconstructed as a spring with stiffness k while its depth increases and e^2 k
/// while it decreases, so that a mass leaves with e times the speed of its arrival.
struct WallSpring {
  double stiffness = 0.0;    ///< k_w, N/m: of a gage in contact along a half circle
  double restitution = 1.0;  ///< e
};

/// Force of such a spring at a depth (m) that changes at a rate (m/s), N.
double spring_force(const WallSpring& spring, double depth, double depth_rate);

/// Force of the wall on a full circle of radius `gage` (no junk slots) around c that moves at v; W,
/// horizontal, N. It is the sum over the spokes of depth times k_w 4 / spokes, so that for a small
/// shift within a wall of the gage's own radius the stiffness is k_w.
Vec3 wall_force(const SpokeWall& wall, const WallSpring& spring, double gage, const Vec3& c_W,
                const Vec3& v_W);

}  // namespace tdbd::reference

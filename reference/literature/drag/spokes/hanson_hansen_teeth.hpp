#pragma once

#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/drag/spokes/spoke_cutter.hpp"
#include "reference/literature/roller/roller_bit.hpp"

namespace tdbd::reference {

/// A tooth of the roller cone bits that Hanson and Hansen's program was later given. SEEN in the thesis (2.2): teeth
/// are spheres; each cone has a degree of freedom of its own, independent of all others.
struct SphereTooth {
  std::size_t cone = 0, row = 0;
  double angle = 0.0, radius = 0.0;   ///< gamma_0; rho, of the tip: the centre is a less far out
  double size = 0.0;                  ///< a, m
  Vec3 journal_B, down_B, forward_B;  ///< unit: s, u and s x u of its cone
  Vec3 foot_B;                        ///< m: where the row's plane meets the journal
  Vec3 origin_B;                      ///< m: foot of journal and axis's common perpendicular
};

/// A tooth in space, W.
struct PlacedTooth {
  Vec3 centre_W, out_W;   ///< m; unit, from the journal through the tooth, its direction of entry
  Vec3 tip_W, v_W;        ///< m, m/s
  Vec3 arm_W, journal_W;  ///< m, from the journal's foot to the tip; unit, s
};

/// Throws InputError ("Hanson and Hansen: ...") for a bit without cones or teeth, with more than three cones, or a
/// cone without inertia.
std::vector<SphereTooth> sphere_teeth(const RollerBit& bit);

/// `rate`s: rad/s of bit and cone; v_W: of the bit's origin.
PlacedTooth placed_tooth(const SphereTooth& tooth, const BitPlace& place, double cone_angle,
                         const Vec3& v_W, double bit_rate, double cone_rate);

/// The share of the tooth's direction that is down.
double downwards(const SphereTooth& tooth, double cone_angle);

/// A sphere in the plane of a spoke that passes its centre at this distance: a disc of radius sqrt(a^2 - s^2); half
/// width 0 beyond the sphere.
RimEllipse sphere_section(const Vec3& centre_W, double size, const SpokePlane& plane);

/// Of a sphere pressed into a plane to a depth: pi (2 a d - d^2), of its shadow; 2 pi a d, of its surface; the cap's
/// volume pi d^2 (a - d/3). m2, m3.
double sphere_shadow(double size, double depth);
double sphere_surface(double size, double depth);
double sphere_cap(double size, double depth);

/// Coefficients of a tooth's force, reconstructed: pressure on the shadow against the direction of entry, and friction
/// against the slip across it.
struct ToothRock {
  double pressure = 0.0;     ///< p_n, Pa
  double friction = 0.3;     ///< mu_t
  double slip_speed = 0.01;  ///< m/s, below which friction fades
  double let_go = 0.1e-3;    ///< m of retreat over which the pressure of a crater falls to nothing
};

/// Force on a tooth, N, W. `deepest`: how deep it was before; rock pushes less where it retreats.
Vec3 tooth_force(const ToothRock& rock, double size, double depth, double deepest,
                 const PlacedTooth& tooth);

}  // namespace tdbd::reference

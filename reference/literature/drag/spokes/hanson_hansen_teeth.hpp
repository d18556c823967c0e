#pragma once

#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/drag/spokes/spoke_cutter.hpp"
#include "reference/literature/roller/roller_bit.hpp"

namespace tdbd::reference {

/// A tooth of the roller cone bits that were added to Hanson and Hansen's program later. Stated in
/// the thesis (2.2): teeth are spheres; each cone has its own degree of freedom, independent of all
/// others.
struct SphereTooth {
  std::size_t cone = 0, row = 0;
  double angle = 0.0, radius = 0.0;   ///< gamma_0; rho, of the tip (centre: rho - a)
  double size = 0.0;                  ///< a, m
  Vec3 journal_B, down_B, forward_B;  ///< unit: s, u and s x u of its cone
  Vec3 foot_B;                        ///< m: where the row's plane meets the journal
  Vec3 origin_B;                      ///< m: foot of the common perpendicular of journal and axis
};

/// A tooth in space, W.
struct PlacedTooth {
  Vec3 centre_W, out_W;   ///< m; unit, from the journal through the tooth: its direction of entry
  Vec3 tip_W, v_W;        ///< m, m/s
  Vec3 arm_W, journal_W;  ///< m, from the journal's foot to the tip; unit, s
};

/// Throws InputError ("Hanson and Hansen: ...") for a bit without cones or teeth, with more than
/// three cones, or with a cone without inertia.
std::vector<SphereTooth> sphere_teeth(const RollerBit& bit);

/// Rates: rad/s of bit and cone. v_W: velocity of the bit's origin.
PlacedTooth placed_tooth(const SphereTooth& tooth, const BitPlace& place, double cone_angle,
                         const Vec3& v_W, double bit_rate, double cone_rate);

/// Downward component of the tooth's direction.
double downwards(const SphereTooth& tooth, double cone_angle);

/// Section of a sphere with the plane of a spoke at the distance s from its centre: a disc of
/// radius sqrt(a^2 - s^2); half width 0 beyond the sphere.
RimEllipse sphere_section(const Vec3& centre_W, double size, const SpokePlane& plane);

/// For a sphere pressed into a plane to the depth d: projected area pi (2 a d - d^2), surface 2 pi
/// a d, and volume of the cap pi d^2 (a - d/3). m2, m3.
double sphere_shadow(double size, double depth);
double sphere_surface(double size, double depth);
double sphere_cap(double size, double depth);

/// Coefficients of a tooth's force, reconstructed: pressure on the projected area against the
/// direction of entry, and friction against the slip perpendicular to it.
struct ToothRock {
  double pressure = 0.0;     ///< p_n, Pa
  double friction = 0.3;     ///< mu_t
  double slip_speed = 0.01;  ///< m/s, below which friction decreases
  double let_go = 0.1e-3;    ///< m of retreat over which the pressure in a crater decreases to zero
};

/// Force on a tooth, N, W. `deepest`: its largest penetration so far; the force is smaller where
/// the tooth retreats.
Vec3 tooth_force(const ToothRock& rock, double size, double depth, double deepest,
                 const PlacedTooth& tooth);

}  // namespace tdbd::reference

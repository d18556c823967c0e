#pragma once

#include <array>

#include "reference/literature/drag/spokes/hanson_hansen_path.hpp"
#include "reference/literature/drag/spokes/spoke_crossings.hpp"
#include "reference/literature/drag/spokes/spoke_wall.hpp"

namespace tdbd::reference {

/// Equations (2.1) to (2.3) of the thesis, of Hanson and Hansen (1995): four degrees of freedom of
/// the bit, one of the rock. Stated there, except for the sign of fz:
///
///   M c'' + Dt c' + Kt (c - cp) = f,  Mrock cr'' + Drock cr' + Krock cr = -fz,
///   I th'' + Dr th' + Kr (th - th_p) = t
///
/// Our excerpt, in which minus signs are missing, shows no sign. With f the force on the bit, the
/// rock is subject to -fz (RockSign::newton); with + momentum is not conserved, as the tests show.
enum class RockSign { newton, as_extracted };

struct DrillStringAndRock {
  double mass = 1000.0, inertia = 100.0;                  ///< M, kg; I, kg m2
  Mat3 damping = Mat3::Zero(), stiffness = Mat3::Zero();  ///< Dt, N s/m; Kt, N/m
  double turn_damping = 0.0, turn_stiffness = 0.0;        ///< Dr, N m s; Kr, N m
  double rate = 0.0, speed = 0.0;       ///< cp = (0, 0, top_z + rate t), th_p = top_angle + speed t
  double top_z = 0.0, top_angle = 0.0;  ///< m, rad
  double rock_mass = 0.0;               ///< Mrock, kg; 0: the rock does not move
  double rock_damping = 0.0, rock_stiffness = 0.0;
  RockSign sign = RockSign::newton;
};

/// c (0..2), c' (3..5), th, th', cr, cr'; then phi, phi' of up to three cones. SI, W.
inline constexpr std::size_t bit_unknowns = 10, most_cones = 3;
using HansonHansenState = std::array<double, bit_unknowns + 2 * most_cones>;

/// Loads of rock and wall: N; N m about the bit's axis; N m about each cone's journal.
struct HansonHansenLoad {
  Vec3 force_W = Vec3::Zero();
  double torque = 0.0;
  std::array<double, most_cones> cones{};
};

/// Computes the rates of the unknowns of bit and rock, but not of the cones
/// (hanson_hansen_cones.hpp).
void string_and_rock_rates(const DrillStringAndRock& system, double time,
                           const HansonHansenState& y, const HansonHansenLoad& load,
                           HansonHansenState& rates);

/// The bit's pose relative to the rock, whose frame moves along z by cr.
BitPlace place_in_rock(const HansonHansenState& y);

/// Momentum of bit and rock along z, N s.
double axial_momentum(const DrillStringAndRock& system, const HansonHansenState& y);

}  // namespace tdbd::reference

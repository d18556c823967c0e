#pragma once

#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// Kinematics of teeth after Ma and Yang (1985) and Ma and Azar, thesis 2.2. Stated in the thesis:
/// cylindrical coordinates for the bit and a frame for each cone; the bit turns about its axis and
/// moves along it, and the cones turn; velocity and acceleration by differentiation; mean rates of
/// rotation are input. Not known: the equations. Those used here are derived for the same motion.
namespace tdbd::reference {

/// A coordinate as a function of time: rad or m, and its two derivatives.
struct Course {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

/// A coordinate with a constant rate, `time` (s) after it was `start`.
Course steady_course(double start, double rate, double time);

/// The bit's own motion: its angle about +z and its depth (z down).
struct RollerMotion {
  Course turn;   ///< rad
  Course depth;  ///< m
};

/// Motion of a point of a cone: place (m), velocity (m/s), acceleration (m/s2), in one frame.
struct ToothState {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
};

/// Place of a tooth on its cone at the cone's angle 0 (RollerRow).
struct ToothPlace {
  double along = 0.0, radius = 0.0, angle = 0.0;
};

/// The motion of a tooth relative to the rock, in the axes (e_r, e_t, e_z) that turn with the bit
/// at the azimuth of the cone's journal; their origin is on the bit's axis at depth 0. `cone_turn`:
/// the cone's angle about s, rad. A bit that turns about +z rolls its cones with a negative rate.
ToothState tooth_state(const RollerCone& cone, const ToothPlace& tooth, const RollerMotion& bit,
                       const Course& cone_turn);

/// The same vectors in the axes of space.
ToothState in_space(const RollerCone& cone, const RollerMotion& bit, const ToothState& turning);

/// Ma and Yang's coordinates of a place in the turning frame.
struct CylindricalPlace {
  double radius = 0.0;   ///< m, from the bit's axis
  double azimuth = 0.0;  ///< rad, in space
  double depth = 0.0;    ///< m
};
CylindricalPlace cylindrical(const RollerCone& cone, const RollerMotion& bit, const Vec3& place);

/// All teeth in space: cone by cone, row by row, tooth by tooth. `cone_turns`: one per cone.
/// `teeth_W` is resized once and overwritten afterwards.
void place_teeth(const RollerBit& bit, const RollerMotion& motion,
                 const std::vector<Course>& cone_turns, std::vector<ToothState>& teeth_W);

/// Ratio of cone speed to bit speed at which the row's lowest point does not slip along the motion:
/// cos(beta) L/rho + sin(beta).
double rolling_ratio(const RollerCone& cone, const RollerRow& row);

/// Slip, m/s, of the row's lowest point at a cone speed of `ratio` times the bit's (rad/s).
struct RowSlip {
  double tangential = 0.0;  ///< along e_t: omega (q_r - ratio rho)
  double radial = 0.0;      ///< along e_r: -omega e
};
RowSlip slip_at_the_lowest(const RollerCone& cone, const RollerRow& row, double ratio,
                           double bit_speed);

}  // namespace tdbd::reference

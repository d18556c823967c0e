#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/cone_parts.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {

/// A cone's mass and its deviation from the assumptions of the integrator (thesis: 5.1): dynamic
/// symmetry about its axis, with its centre of mass on it.
struct ConeMass {
  MassProperties body_K;         ///< of shell and teeth, in K at angle 0
  double axial_inertia = 0.0;    ///< kg m2, Ic, about the journal's axis
  double asymmetry = 0.0;        ///< (It1 - It2) / Ic, transverse inertias about the centre
  double centre_off_axis = 0.0;  ///< m
};

/// Computes the mass of one cone, shell and teeth. `cone`: index into Bit::cones.
ConeMass cone_mass(const Bit& bit, int cone);

/// Where a row of teeth cuts.
struct RowMeasures {
  double radius = 0.0;         ///< m, of the tip from the journal's axis
  double bit_radius = 0.0;     ///< m, of the tip from the bit's axis when it is deepest
  double height = 0.0;         ///< m, of the tip above the bit's origin at that place
  double reach = 0.0;          ///< m, largest radius of the teeth from the bit's axis
  double rolling_ratio = 0.0;  ///< bit_radius / radius: cone's speed over the bit's; 0 on the axis
};

/// The deepest place of a point of a cone at `radius` (m) from the journal's axis and z_K (m) along
/// it.
Vec3 deepest_B(const Cone& cone, double radius, double z_K);

/// The measures of a row of a cone.
RowMeasures row_measures(const Cone& cone, const ToothRow& row);

/// A contact of a tooth with rock, and the resistance of the rock against slip there.
struct ConeContact {
  Vec3 x_B = Vec3::Zero();
  double weight = 0.0;  ///< in any unit; the removed volume in a run
};

/// The balance of moments that determines a cone's speed: phi' = -moment / inertia. Balances may be
/// added and scaled.
struct SlipBalance {
  double moment = 0.0;   ///< sum w s . (r x v), v: the contact's velocity if the cone did not turn
  double inertia = 0.0;  ///< sum w |s x r|^2

  template <class Archive>
  void serialize(Archive& a) {
    a(moment, inertia);
  }
};

/// Computes the balance of a cone's contacts. At the speed of bit (13) the torque about the journal
/// of a resistance linear in slip is zero. Contact i is subject to the force -w_i (v_i + phi' s x
/// r_i), with s the cone's Z, r_i from a point of the journal and v_i from the bit's twist. X_BK
/// may be at any cone angle. Reconstructed.
SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts);

/// The tip of a tooth in its frame T, m: on its axis, at the height of its mesh.
Vec3 tooth_tip_P(const Part& tooth);

/// The ratio of cone speed to bit speed at which the gage row rolls on the bottom without slip
/// (RowMeasures::rolling_ratio). Of several gage rows, or if there is none, the row farthest
/// from the bit's axis is used; for a cone of solids, without rows, Cone::rolling_ratio. Usual
/// values: 1.2 to 1.5 (from memory, without a source).
double rolling_ratio_of_gage_row(const Cone& cone);

/// The same for a cone whose shape is known only from its parts: the ratio of the tooth whose tip,
/// where it is deepest, is farthest from the bit's axis. A tip is a tooth's vertex farthest from
/// the journal's axis. Without teeth, all cutting parts count; 0 if there are none. `index`: of the
/// cone. Not in the thesis.
double rolling_ratio_of_parts(const Cone& cone, int index, const std::vector<Part>& parts);

/// How far a point of a cone reaches in a full turn of the cone, with the bit at rest.
struct ConeReach {
  double radius = 0.0;  ///< m, largest distance from the bit's axis
  double angle = 0.0;   ///< rad about the cone's Z (in K at angle 0) at that place
  double depth = 0.0;   ///< m, largest z in the bit's frame
};

/// The reach of the point (s, r) of a cone with frame X_BK. The radius is largest at a root of a
/// trigonometric polynomial of degree 2, which is bracketed and bisected to rounding.
ConeReach reach_of(const Pose& X_BK, const ShellPoint& p);

/// The reach of a meridian: the largest over its corners.
ConeReach reach_of(const Pose& X_BK, const Meridian& m);

/// The position along the journal (ConeLayout::apex, m) at which the cone's gage rows reach
/// `gage_radius` (m). Throws InputError if there is none: an offset beyond the gage, or a cone too
/// large or too small for the bit. Requires a gage row.
double apex_for_gage(ConeLayout cone, double gage_radius);

/// Largest distance (m) from the bit's axis that a cutting part's vertex reaches during a turn of
/// its cone.
double largest_turned_radius(const Bit& bit);

/// Quantifies, for a bit that rotates steadily about its axis, what the equations of motion neglect
/// about a cone. They assume that it is symmetric about its axis, with its centre of mass on it
/// (thesis 5.1).
struct ConeAssumptions {
  double cone_speed = 0.0;        ///< rad/s, relative to the bit
  double unbalance_force = 0.0;   ///< N, m e phi'^2
  double unbalance_share = 0.0;   ///< over the bit's weight
  double gravity_torque = 0.0;    ///< N m about the journal, upper bound: m g e
  double modulation_once = 0.0;   ///< amplitude at the cone's frequency, over the bit's axial
                                  ///< inertia
  double modulation_twice = 0.0;  ///< amplitude at twice the cone's frequency
  double frequency = 0.0;         ///< Hz, of the cone
  double torque_error = 0.0;      ///< N m, bound on what the cone's momentum equation neglects
  double torque_share = 0.0;      ///< torque_error over Ic phi'^2; 0 for a cone at rest
};

/// Computes the error of the assumptions about a cone that turns at cone_ratio times the bit's
/// speed (rad/s). The cone's share of the bit's axial inertia is constant except for amplitudes of
/// at most A1 and A2 at once and twice the cone's frequency, bit (11). From the kinetic energy
/// (W^2/2) I(phi) follows a torque that drives the cone and is neglected: (W^2/2) dI/dphi, at most
/// W^2 (A1/2 + A2), and the torque m g e of gravity, bit (12). First order in the asymmetry.
/// Bearing friction is not included because bearings are not modelled. Not in the thesis.
ConeAssumptions cone_assumptions(const Bit& bit, int cone, double bit_speed, double cone_ratio);

}  // namespace tdbd::bit

#pragma once

#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Effective back rake of a face (rad, 0 to a right angle), forces (2): the angle between its
/// outward normal X and its velocity v. It has no sign: a face that leans over the rock ahead of it
/// and one that leans back as much read the same, and side rake counts. 0 at rest; a right angle
/// for a face that moves backwards. Thesis: nomenclature, Ebr ("effective back rake of cutter,
/// angle of attack"). The section's angle of attack (rock/section) is the complement: a right angle
/// less the rake.
double effective_back_rake(const Vec3& face_normal, const Vec3& velocity);

/// The directions of a force on a cut: F = -Ft e1 - Fn e2. Thesis: app. C, E1 and E2;
/// reconstructed.
struct CutFrame {
  Vec3 e1 = Vec3::Zero();  ///< along the velocity
  Vec3 e2 = Vec3::Zero();  ///< the normal into the rock, made perpendicular to the velocity
};

/// e1 and e2 of forces (3), from a velocity v over the rock and a unit normal n into it; with
/// a = v.n / |v|, e1 = v/|v| and e2 = (n - a e1)/|n - a e1| wherever a part drills. Elsewhere these
/// make no sense, and the rules are ours:
/// - within 30 degrees of a plunge or a withdrawal along n, e2 shrinks steadily to 0, so that no
///   force flips when the sideways motion does;
/// - where the part leaves the rock (a < 0), e1 loses its component along n;
/// - at rest e1 = 0 and e2 = n.
/// So for any Ft, Fn >= 0 the force never pulls the bit into the rock (F.n <= 0) and does no
/// positive work on it (F.v <= 0). The frame is continuous in v except at rest.
CutFrame cut_frame(const Vec3& velocity, const Vec3& normal);

/// Share of a law's force that acts at a speed u (m/s), u/sqrt(u^2 + slip_speed^2): it makes the
/// force a continuous function of the velocity, zero at rest. So a bit that stands on rock under
/// load creeps, slower than slip_speed. Ours.
double slip_share(double speed, double slip_speed);

/// How two surfaces slide over each other.
struct Sliding {
  double mu = 0.0;               ///< 1, coefficient of friction at low speed
  double weakening = 0.0;        ///< 1, share of mu that is lost at high speed
  double weakening_speed = 1.0;  ///< m/s, at which most of that is lost
};

/// The sliding of a law that has these coefficients.
template <class L>
Sliding sliding_of(const L& law) {
  return {law.mu, law.weakening, law.weakening_speed};
}

/// mu (1 - weakening (1 - exp(-u/weakening_speed))): friction that falls with the speed u (m/s),
/// one cause of stick-slip. The form is that of whole-bit codes, applied here at one contact.
double friction_at(const Sliding& sliding, double speed);

/// The force of a cut with the law's Fn and Ft (N, >= 0): -share (Ft e1 + Fn e2), forces (3).
PartForce cutting_force(const PartCut& cut, double Ft, double Fn, double slip_speed);

}  // namespace tdbd::forces

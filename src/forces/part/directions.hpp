#pragma once

#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// The directions of a force on a cut: F = -Ft e1 - Fn e2. Thesis: app. C, E1 and E2 [R].
struct CutFrame {
  Vec3 e1 = Vec3::Zero();  ///< along the velocity
  Vec3 e2 = Vec3::Zero();  ///< the normal into the rock, made perpendicular to the velocity
};

/// e1 and e2 of a velocity v over the rock and a unit normal n into it, with a = v.n / |v|:
///   e1 = v/|v|, e2 = (n - a e1)/|n - a e1|
/// wherever a part drills. Ours where that has no sense:
/// - within 30 degrees of a plunge or a withdrawal along n, e2 shrinks steadily to 0, so that no
///   force turns about at once when the sideways motion does;
/// - where the part leaves the rock (a < 0), e1 loses its component along n;
/// - at rest e1 = 0 and e2 = n.
/// So for any Ft, Fn >= 0 the force never pulls the bit into the rock (F.n <= 0) and does no
/// positive work on it (F.v <= 0). The frame is continuous in v, rest aside.
CutFrame cut_frame(const Vec3& velocity, const Vec3& normal);

/// Share of a law's force that acts at a speed, u/sqrt(u^2 + slip_speed^2): it makes the force a
/// continuous function of the velocity, at rest as well, where there is none. So a bit at rest
/// under load creeps, at less than slip_speed. Ours.
double slip_share(double speed, double slip_speed);

/// How two surfaces slide over each other.
struct Sliding {
  double mu = 0.0;               ///< 1, coefficient of friction at low speed
  double weakening = 0.0;        ///< 1, share of mu that is lost at high speed
  double weakening_speed = 1.0;  ///< m/s, at which most of that is lost
};

/// mu (1 - weakening (1 - exp(-u/weakening_speed))): friction that falls with speed, one cause of
/// stick-slip. The form is that of codes for whole bits (domain: Simulator4nDOF), at one contact.
double friction_at(const Sliding& sliding, double speed);

/// The force of a cut with the law's Fn and Ft (N, >= 0): -share (Ft e1 + Fn e2).
PartForce cutting_force(const PartCut& cut, double Ft, double Fn, double slip_speed);

/// The force of a surface that presses with Fn (N, >= 0) and slides: -share Fn n and, against the
/// slip (the velocity along the surface), friction times share Fn. The rock is crushed, it does not
/// spring back: where the part leaves the rock, Fn n loses its component along the velocity, so
/// that it does no work. F.n <= 0 and F.v <= 0, and continuous, as above. Ours.
PartForce pressing_force(const PartCut& cut, double Fn, const Sliding& sliding, double slip_speed);

}  // namespace tdbd::forces

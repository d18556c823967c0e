#pragma once

#include "forces/part_cut.hpp"

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

/// Share of the tangential force that acts at a speed, u/sqrt(u^2 + slip_speed^2): what turns a
/// force against the motion into a continuous function of it. 0 at rest. Ours.
double slip_share(double speed, double slip_speed);

/// The force of a cut with the law's Fn and Ft (N, >= 0): -share Ft e1 - Fn e2.
PartForce cutting_force(const PartCut& cut, double Ft, double Fn, double slip_speed);

/// The force of a surface that presses with Fn (N, >= 0) and slides with the given coefficient of
/// friction: -Fn n and, against the slip (the velocity along the surface), friction Fn. The rock is
/// crushed, it does not spring back: where the part leaves the rock, Fn n loses its component along
/// the velocity, so that it does no work. F.n <= 0 and F.v <= 0, as above. Ours.
PartForce pressing_force(const PartCut& cut, double Fn, double friction, double slip_speed);

}  // namespace tdbd::forces

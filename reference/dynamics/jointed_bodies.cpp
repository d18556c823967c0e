#include "reference/dynamics/jointed_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/dynamics/jointed_equations.hpp"

namespace tdbd::reference {
namespace {

/// Inertia about a point at distance d from the centre.
Mat3 moved_inertia(const RigidBody& b, const Vec3& d) {
  return b.inertia_B + b.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
}

Vec3 common_centre(const std::vector<RigidBody>& bodies) {
  Vec3 moment = Vec3::Zero();
  double mass = 0.0;
  for (const RigidBody& b : bodies) {
    moment += b.mass * b.centre_B;
    mass += b.mass;
  }
  return moment / mass;
}

double total_mass(const std::vector<RigidBody>& bodies) {
  double mass = 0.0;
  for (const RigidBody& b : bodies) mass += b.mass;
  return mass;
}

/// The point about which the whole system rotates, in the bit's frame.
Vec3 pivot(const JointedBit& bit) {
  return bit.mount == Mount::pinned ? Vec3(Vec3::Zero()) : common_centre(bodies(bit));
}

/// Bodies in their places, moving as one rigid body plus the cones' spins.
std::vector<BodyMotion> assemble(const JointedBit& bit, const JointedState& start) {
  const Vec3 w_W = start.R_WB * start.w_B, pivot_B = pivot(bit);
  std::vector<BodyMotion> motions;
  for (const RigidBody& b : bodies(bit)) {
    const Vec3 x_W = start.R_WB * (b.centre_B - pivot_B);
    motions.push_back({x_W, Eigen::Quaterniond(start.R_WB), w_W.cross(x_W), w_W});
  }
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const Vec3 spin_W = start.spins[k] * (start.R_WB * bit.cones[k].axis_B);
    motions[k + 1].w_W += spin_W;
    motions[k + 1].v_W += spin_W.cross(start.R_WB * bit.cones[k].off_axis_B);
  }
  return motions;
}

Vec3 angular_momentum(const std::vector<RigidBody>& bodies, const std::vector<BodyMotion>& motions,
                      const Vec3& about_W) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    sum += bodies[i].mass * (motions[i].x_W - about_W).cross(motions[i].v_W) +
           space_inertia(bodies[i], motions[i]) * motions[i].w_W;
  return sum;
}

double energy(const JointedBit& bit, const std::vector<BodyMotion>& motions) {
  const std::vector<RigidBody> all = bodies(bit);
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
    sum += 0.5 * all[i].mass * motions[i].v_W.squaredNorm() +
           0.5 * motions[i].w_W.dot(space_inertia(all[i], motions[i]) * motions[i].w_W) -
           all[i].mass * bit.gravity * motions[i].x_W.z();
  return sum;
}

Vec3 centre_of_mass(const std::vector<RigidBody>& bodies, const std::vector<BodyMotion>& motions) {
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) moment += bodies[i].mass * motions[i].x_W;
  return moment / total_mass(bodies);
}

/// The angle of the rotation about `axis` that maps attitude A to attitude B, unwrapped to the
/// value nearest to `about`.
double angle_between(const Mat3& A, const Mat3& B, const Vec3& axis, double about) {
  const Eigen::Quaterniond q(Mat3(A.transpose() * B));
  const double wrapped = 2.0 * std::atan2(q.vec().dot(axis), q.w());
  constexpr double turn = 2.0 * std::numbers::pi;
  return wrapped + turn * std::round((about - wrapped) / turn);
}

JointedState bit_state_of(const JointedBit& bit, const Assembly& a) {
  const std::vector<RigidBody> all = bodies(bit);
  JointedState s;
  s.R_WB = attitude(a.motions[0]);
  s.w_B = s.R_WB.transpose() * a.motions[0].w_W;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const BodyMotion& cone = a.motions[k + 1];
    const Vec3& axis_B = bit.cones[k].axis_B;
    const Vec3 axis_W = s.R_WB * axis_B;
    s.spins.push_back((cone.w_W - a.motions[0].w_W).dot(axis_W));
    s.cone_angles.push_back(angle_between(s.R_WB, attitude(cone), axis_B, a.cone_angles[k]));
    s.cone_momenta.push_back(axis_W.dot(space_inertia(all[k + 1], cone) * cone.w_W));
  }
  const bool pinned = bit.mount == Mount::pinned;
  s.momentum_W = angular_momentum(all, a.motions,
                                  pinned ? Vec3(Vec3::Zero()) : centre_of_mass(all, a.motions));
  s.energy = energy(bit, a.motions);
  return s;
}

void measure_drift(const JointedBit& bit, const Assembly& a, JointedRun& run) {
  const Mat3 R_WB = attitude(a.motions[0]);
  const auto place = [&](std::size_t i, const Vec3& r_B) {
    return Vec3(a.motions[i].x_W + attitude(a.motions[i]) * r_B);
  };
  const std::vector<RigidBody> all = bodies(bit);
  if (bit.mount == Mount::pinned) run.largest_gap = place(0, -all[0].centre_B).norm();
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const Vec3& bearing_B = bit.cones[k].bearing_B;
    const double gap =
        (place(0, bearing_B - all[0].centre_B) - place(k + 1, bearing_B - all[k + 1].centre_B))
            .norm();
    const Vec3 in_body = R_WB * bit.cones[k].axis_B;
    const Vec3 in_cone = attitude(a.motions[k + 1]) * bit.cones[k].axis_B;
    run.largest_gap = std::max(run.largest_gap, gap);
    run.largest_tilt = std::max(run.largest_tilt, in_body.cross(in_cone).norm());
  }
}

}  // namespace

EquivalentGyrostat equivalent(const JointedBit& bit) {
  const std::vector<RigidBody> all = bodies(bit);
  Mat3 inertia_B = Mat3::Zero();
  for (const RigidBody& b : all) inertia_B += moved_inertia(b, b.centre_B - pivot(bit));
  std::vector<dynamics::Cone> cones;
  for (const JointedCone& c : bit.cones) cones.push_back({c.axis_B, c.axial_inertia});
  EquivalentGyrostat e{dynamics::make_gyrostat(inertia_B, cones), {}};
  e.loads.body_torque_B = bit.torque_B;
  e.loads.cones = bit.loads;
  const Vec3 arm_B = common_centre(all) - pivot(bit);
  if (arm_B.norm() > 0.0) {
    e.loads.gravity_arm_B = arm_B.normalized();
    e.loads.gravity_moment = -total_mass(all) * bit.gravity * arm_B.norm();
  }
  return e;
}

JointedRun jointed_run(const JointedBit& bit, const JointedState& start, double t_end,
                       const OdeTolerance& tolerance) {
  const Assembly assembly{assemble(bit, start), std::vector<double>(bit.cones.size(), 0.0)};
  std::vector<double> y = unknowns(assembly);
  JointedRun run;
  run.evaluations = integrate(jointed_equations(bit), OdeMethod::rk8pd, tolerance, 0.0, t_end, y);
  const Assembly end = assembly_of(y, bit.cones.size());
  run.state = bit_state_of(bit, end);
  measure_drift(bit, end, run);
  return run;
}

}  // namespace tdbd::reference

#include "dynamics/drilling/middle_split.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "dynamics/drilling/columns.hpp"
#include "dynamics/drilling/velocity.hpp"
#include "dynamics/rotation/drift.hpp"

namespace tdbd::dynamics {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Whether the wall resists at either end of a half step.
bool rubs(const Wall& wall, const Configuration& a, const Configuration& b) {
  return wall_resists(wall) && (a.contact.depth > 0.0 || b.contact.depth > 0.0);
}

/// Rotates a vector about z by an angle given by its cosine and sine.
Vec3 turned(const Vec3& p, double cosine, double sine) {
  return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y(), p.z()};
}

using Directions = std::array<Direction, 3>;

/// Speeds of the contact for the momenta in `w`: slip around the wall, slip along z, radial speed,
/// m/s.
Vec3 speeds_at_contact(const DrillingSystem& s, const Configuration& at,
                       const Directions& directions, FlowWork& w) {
  w.start.resize(w.momenta.size());
  velocities_of(s, at, w.momenta, w.start);
  Vec3 speeds;
  for (int i = 0; i < 3; ++i) {
    const Direction& d = directions[tdbd::at(i)];
    speeds[i] = d.force_W.dot(w.start.head<3>()) + d.torque_W.dot(w.start.segment<3>(3));
  }
  return speeds;
}

/// T: the impulse that rotates the momenta with the contact from one geometry to another, (24). The
/// momenta are rotated about z, and an impulse at the contact then restores the speeds of the
/// contact. Zero if the ring touches the wall in only one of the geometries.
Vec6 turning_impulse(const DrillingSystem& s, const Configuration& from, const Configuration& to,
                     const DrillingState& state, FlowWork& w) {
  Vec6 T = Vec6::Zero();
  if (from.contact.depth <= 0.0 || to.contact.depth <= 0.0) return T;
  const double cosine = from.contact.outward_W.dot(to.contact.outward_W),
               sine = from.contact.outward_W.cross(to.contact.outward_W).z();
  const Vec3 &p = state.momentum_W, &pi = state.rotation.momentum_W;
  T << turned(p, cosine, sine) - p, turned(pi, cosine, sine) - pi;
  const Directions there = contact_directions(to.contact);
  momenta_column(s, state, w.momenta);
  const Vec3 before = speeds_at_contact(s, from, contact_directions(from.contact), w);
  w.momenta.head<6>() += T;
  const Vec3 after = speeds_at_contact(s, to, there, w);
  Mat3 mobility;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Direction &a = there[tdbd::at(i)], &b = there[tdbd::at(j)];
      mobility(i, j) =
          a.force_W.dot(b.force_W) / s.mass + a.torque_W.dot(to.mobility_W * b.torque_W);
    }
  const Vec3 impulse = mobility.llt().solve(before - after);
  for (int i = 0; i < 3; ++i) {
    T.head<3>() += impulse[i] * there[tdbd::at(i)].force_W;
    T.tail<3>() += impulse[i] * there[tdbd::at(i)].torque_W;
  }
  return T;
}

/// Performs a quarter step in each geometry, with the turning impulse between them.
void take_quarters(const DrillingSystem& s, double h, const Configuration& first,
                   const Configuration& second, DrillingState& state, EnergyLedger* ledger,
                   HalfWork& w) {
  const Vec6 T = turning_impulse(s, first, second, state, w.flow);
  w.flow.force = w.force;
  w.flow.force.head<6>() -= T / (0.5 * h);
  resisted_flow(s, first, 0.25 * h, state, ledger, w.flow);
  w.mean = 0.5 * w.flow.mean;
  state.momentum_W += T.head<3>();
  state.rotation.momentum_W += T.tail<3>();
  resisted_flow(s, second, 0.25 * h, state, ledger, w.flow);
  w.mean += 0.5 * w.flow.mean;
}

/// Performs half a drift. Returns false if it does not converge.
bool coast_halfway(const DrillingSystem& s, double h, const DrillingState& from, DrillingState& to,
                   Configuration& middle) {
  to = from;
  if (coast(s.gyrostat, s.integrator.drift, 1, 0.5 * h, to.rotation) == LieOutcome::too_long)
    return false;
  to.rotation.time += 0.5 * h;
  to.c_W += (0.5 * h / s.mass) * to.momentum_W;
  to.upper.z += 0.5 * h * to.upper.rate;
  to.upper.angle += 0.5 * h * to.upper.speed;
  if (s.rock.mass > 0.0) to.rock_z += 0.5 * h / s.rock.mass * to.rock_momentum;
  configure(s, to, middle);
  return true;
}

/// Rotates the momenta about z by the angle that a touching ring travels around the wall in half a
/// step.
void turn_with_the_ring(const DrillingSystem& s, double h, const Configuration& node,
                        HalfWork& work) {
  const WallContact& c = node.contact;
  if (c.depth <= 0.0) return;
  DrillingState& x = work.trial;
  momenta_column(s, x, work.flow.momenta);
  work.mean.resize(work.flow.momenta.size());
  velocities_of(s, node, work.flow.momenta, work.mean);
  const Vec3 ring = work.mean.head<3>() + Vec3(work.mean.segment<3>(3)).cross(c.ring_arm_W);
  constexpr double most = 0.9;  // largest sine
  const double sine =
      std::clamp(0.5 * h * ring.dot(c.tangent_W) / (s.wall.clearance + c.depth), -most, most);
  const double cosine = std::sqrt(1.0 - sine * sine);
  x.momentum_W = turned(x.momentum_W, cosine, sine);
  x.rotation.momentum_W = turned(x.rotation.momentum_W, cosine, sine);
}

}  // namespace

double cone_share(ConeImpulse impulse, Half half) {
  if (impulse == ConeImpulse::halves) return 1.0;
  return half == Half::closing ? 2.0 : 0.0;
}

void take_half_step(const DrillingSystem& s, const HalfStep& step, DrillingState& state,
                    EnergyLedger* ledger, HalfWork& w, DrillingVelocity& mean) {
  const auto& [h, half, node, middle, wrench, share] = step;
  force_column(s, node.conservative, wrench, share, w.force);
  const bool opens = half == Half::opening;
  if (opens) follow_bit(s, node, 0.5 * h, state);
  if (rubs(s.wall, node, middle)) {
    take_quarters(s, h, opens ? node : middle, opens ? middle : node, state, ledger, w);
    from_column(s, w.mean, mean);
  } else {
    w.flow.force = w.force;
    resisted_flow(s, node, 0.5 * h, state, ledger, w.flow);
    from_column(s, w.flow.mean, mean);
  }
  if (!opens) follow_bit(s, node, 0.5 * h, state);
}

void find_middle(const DrillingSystem& s, double h, const Configuration& node, const Wrench& wrench,
                 const DrillingState& state, HalfWork& w, Configuration& middle) {
  w.trial = state;
  turn_with_the_ring(s, h, node, w);
  if (!wall_resists(s.wall) || !coast_halfway(s, h, w.trial, w.halfway, middle)) {
    middle = node;
    return;
  }
  if (!rubs(s.wall, node, middle)) return;
  w.trial = state;
  const double share = cone_share(wrench.cone_impulse, Half::opening);
  take_half_step(s, {h, Half::opening, node, middle, wrench, share}, w.trial, nullptr, w,
                 w.mean_velocity);
  if (!coast_halfway(s, h, w.trial, w.halfway, middle)) middle = node;
}

}  // namespace tdbd::dynamics

#include "dynamics/drilling/response.hpp"

namespace tdbd::dynamics {
namespace {

/// The component of a wrench along a degree of freedom.
double& entry(const DrillingSystem& s, int freedom, Wrench& w) {
  if (freedom < 3) return w.force_W[freedom];
  if (freedom < 6) return w.torque_W[freedom - 3];
  return freedom < 6 + cones_of(s) ? w.cones[at(freedom - 6)] : w.rock_force;
}

/// Probe, N or N m. The map is affine, so the probe only needs to be large compared with rounding.
double probe_along(const DrillingSystem& s, int freedom) {
  constexpr double force = 1e3, torque = 1e2;
  return freedom < 3 || freedom == 6 + cones_of(s) ? force : torque;
}

}  // namespace

void find_response(const DrillingSystem& s, double h, const Drilling& d, KicksLeft kicks,
                   DrillingWork& work, ResponseWork& room, Response& r) {
  const int n = freedoms(s);
  Wrench& w = room.wrench;
  w.force_W = w.torque_W = Vec3::Zero();
  w.cones.assign(s.gyrostat.cones.size(), 0.0);
  w.rock_force = 0.0;
  w.cone_impulse = kicks == KicksLeft::opening ? ConeImpulse::halves : ConeImpulse::at_end;
  const auto ask = [&](Eigen::VectorXd& u) {
    velocity_after(s, h, d, kicks, w, work, room.velocity);
    to_column(s, room.velocity, u);
  };
  ask(r.free);
  r.A.resize(n, n);
  for (int j = 0; j < n; ++j) {
    double& probed = entry(s, j, w);
    probed = probe_along(s, j);
    ask(room.column);
    r.A.col(j) = (room.column - r.free) / probed;
    probed = 0.0;
  }
}

}  // namespace tdbd::dynamics

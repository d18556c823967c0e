#include "dynamics/drilling/velocity.hpp"

#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {

void velocity(const DrillingSystem& s, const Configuration& at, const DrillingState& state,
              DrillingVelocity& out) {
  const RotationState& r = state.rotation;
  out.v_W = state.momentum_W / s.mass;
  out.w_W = at.mobility_W * (r.momentum_W - at.R_WB * cone_momentum_sum(s.gyrostat, r));
  const Vec3 w_B = at.R_WB.transpose() * out.w_W;
  out.cone_rates.resize(r.cone_momenta.size());
  for (std::size_t k = 0; k < r.cone_momenta.size(); ++k)
    out.cone_rates[k] = cone_rate<double>(s.gyrostat.cones[k], r.cone_momenta[k], w_B);
  out.rock = s.rock.mass > 0.0 ? state.rock_momentum / s.rock.mass : 0.0;
}

DrillingVelocity velocity(const DrillingSystem& s, const DrillingState& state) {
  Configuration at;
  configure(s, state, at);
  DrillingVelocity out;
  velocity(s, at, state, out);
  return out;
}

DrillingState make_drilling_state(const DrillingSystem& s, const Pose& X_WB,
                                  const DrillingVelocity& v, std::span<const double> cone_angles) {
  DrillingState state;
  state.rotation =
      make_state(s.gyrostat, X_WB.R, X_WB.R.transpose() * v.w_W, v.cone_rates, cone_angles);
  state.c_W = X_WB * s.centre_B;
  state.momentum_W = s.mass * v.v_W;
  state.rock_momentum = s.rock.mass * v.rock;
  return state;
}

Vec3 hanging_rest_W(const DrillingSystem& s, const DrillingState& state) {
  const Vec3 stretch = s.spring.completeOrthogonalDecomposition().solve(weight_W(s));
  return bit_pose(s, state) * s.string.attachment_B - stretch;
}

double power_on_bit(const Wrench& w, const DrillingVelocity& v, double cone_share) {
  double power = w.force_W.dot(v.v_W) + w.torque_W.dot(v.w_W);
  for (std::size_t k = 0; k < w.cones.size(); ++k)
    power += cone_share * w.cones[k] * v.cone_rates[k];
  return power;
}

double power_on_rock(const Wrench& w, const DrillingVelocity& v) { return w.rock_force * v.rock; }

}  // namespace tdbd::dynamics

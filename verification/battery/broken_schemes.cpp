#include "verification/battery/broken_schemes.hpp"

namespace tdbd::battery {
namespace {

using dynamics::BodyFlow;
using dynamics::Gyrostat;
using dynamics::Vec3Of;

/// The scalar that a state is made of.
template <class State>
using ScalarOf = typename std::decay_t<decltype(std::declval<State>().momentum_W)>::Scalar;

}  // namespace

RotationScheme frozen_velocity() {
  return with_drift("frozen velocity", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    const Vec3Of<S> T = h * dynamics::angular_velocity(g, s);
    s.q_WB = s.q_WB * rotation::quaternion_exp<S>(T);
    rotation::renormalise(s.q_WB);
    dynamics::turn_cones<S>(g, h, T, s);
  });
}

RotationScheme no_way_back() {
  return with_drift("no way back", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    BodyFlow<S> f = dynamics::begin_flow(g, s);
    dynamics::flow_about_axis<0>(h / g.principal[0], f);
    dynamics::flow_about_axis<1>(h / g.principal[1], f);
    dynamics::flow_about_axis<2>(h / g.principal[2], f);
    dynamics::apply_turn(g, f, s);
    dynamics::end_flow(g, h, f, s);
  });
}

RotationScheme hasty_cones() {
  return with_drift("hasty cones", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    const Vec3Of<S> turned_B = h * dynamics::angular_velocity(g, s);
    const std::vector<S> angles = s.cone_angles;
    dynamics::drift_split(g, h, s);
    s.cone_angles = angles;
    dynamics::turn_cones<S>(g, h, turned_B, s);
  });
}

RotationScheme body_momentum_first() {
  return with_drift("body momentum first", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    const Vec3Of<S> momentum_B = dynamics::body_momentum(s);
    const Eigen::Quaternion<S> before = s.q_WB;
    dynamics::drift_split(g, h, s);
    const Eigen::Quaternion<S> turn = before.conjugate() * s.q_WB;
    s.momentum_W = s.q_WB * (turn.conjugate() * momentum_B);
  });
}

RotationScheme never_renormalised() {
  return with_drift("never renormalised", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    BodyFlow<S> f = dynamics::begin_flow(g, s);
    dynamics::flow_about_axis<0>(0.5 * h / g.principal[0], f);
    dynamics::flow_about_axis<1>(0.5 * h / g.principal[1], f);
    dynamics::flow_about_axis<2>(h / g.principal[2], f);
    dynamics::flow_about_axis<1>(0.5 * h / g.principal[1], f);
    dynamics::flow_about_axis<0>(0.5 * h / g.principal[0], f);
    const Vec3Of<S> v = g.principal_axes_B.cast<S>() * f.turn.vec();
    s.q_WB = s.q_WB * Eigen::Quaternion<S>(f.turn.w(), v[0], v[1], v[2]);
  });
}

RotationScheme spin_first() {
  return with_drift("spin first", [](const Gyrostat& g, double h, auto& s) {
    using S = ScalarOf<std::decay_t<decltype(s)>>;
    const Vec3Of<S> w_B = dynamics::angular_velocity(g, s);
    for (std::size_t k = 0; k < g.cones.size(); ++k) {
      const dynamics::Cone& cone = g.cones[k];
      const S spin = dynamics::cone_rate<S>(cone, s.cone_momenta[k], w_B);
      s.cone_momenta[k] = cone.axial_inertia * (spin + cone.axis_B.cast<S>().dot(w_B));
    }
    dynamics::drift_split(g, h, s);
  });
}

}  // namespace tdbd::battery

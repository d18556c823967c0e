#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "dynamics/drilling/stability.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::response_test {

/// Two cones, moving rock, dampers everywhere, a wall that is smooth: all of it linear.
DrillingSystem linear_bit() {
  DrillingSystem s = coupled_bit(AxialMode::load, DamperEnd::top);
  s.wall.friction = 0.0;
  return s;
}

Wrench some_wrench(int seed) {
  Wrench w;
  const double a = 1.0 + seed;
  w.force_W = Vec3(300.0 * a, -700.0, 2000.0 / a);
  w.torque_W = Vec3(-40.0, 25.0 * a, 60.0);
  w.cones = {3.0 / a, -2.0 * a};
  w.rock_force = -1500.0 * a;
  w.cone_impulse = ConeImpulse::at_end;
  return w;
}

Eigen::VectorXd column_of(const Wrench& w) {
  Eigen::VectorXd f(9);
  f << w.force_W, w.torque_W, w.cones[0], w.cones[1], w.rock_force;
  return f;
}

/// In an open step.
Response response_of(const DrillingSystem& s, double h, DrillingRun& d) {
  open_step(s, h, d, d.work);
  Response response;
  ResponseWork room;
  find_response(s, h, d, RemainingKicks::closing_and_opening, d.work, room, response);
  return response;
}

/// Of the drift that follows when the step is opened: momenta are then those of the drift, positions still
/// count as they were.
Eigen::VectorXd velocity_of_next_drift(const DrillingSystem& s, double h, DrillingRun& d) {
  const Configuration before = d.work.at;
  open_step(s, h, d, d.work);
  DrillingVelocity v;
  Eigen::VectorXd column;
  velocity(s, before, d.state, v);
  to_column(s, v, column);
  return column;
}

/// After the step is closed with the wrench.
TEST(Response, is_the_velocity_of_the_next_drift) {
  constexpr double h = 2e-3, bound = 1e-13;  // of the velocity
  const DrillingSystem s = linear_bit();
  for (int seed = 0; seed < 5; ++seed) {
    DrillingRun d = start(s, smooth_law, coupled_start(s));
    for (int i = 0; i < 10 * seed; ++i) step(s, smooth_law, h, d);
    const Response response = response_of(s, h, d);
    const Wrench w = some_wrench(seed);
    const Eigen::VectorXd told = response.free + response.A * column_of(w);
    close_step(s, h, w, d, d.work);
    const Eigen::VectorXd found = velocity_of_next_drift(s, h, d);
    EXPECT_LT((told - found).norm(), bound * found.norm()) << seed;
    EXPECT_GT((response.A * column_of(w)).norm(), 0.01 * found.norm()) << seed;
  }
}

/// The same of a state between two steps, whose wrench opens the next one.
TEST(Response, of_the_opening_kick_is_the_velocity_of_the_next_drift) {
  constexpr double h = 2e-3, bound = 1e-13;  // of the velocity
  const DrillingSystem s = linear_bit();
  for (int seed = 0; seed < 5; ++seed) {
    DrillingRun d = start(s, smooth_law, coupled_start(s));
    for (int i = 0; i < 10 * seed; ++i) step(s, smooth_law, h, d);
    Response response;
    ResponseWork room;
    find_response(s, h, d, RemainingKicks::opening, d.work, room, response);
    Wrench w = some_wrench(seed);
    w.cone_impulse = ConeImpulse::halves;
    const Eigen::VectorXd predicted = response.free + response.A * column_of(w);
    d.wrench = w;
    const Eigen::VectorXd found = velocity_of_next_drift(s, h, d);
    EXPECT_LT((predicted - found).norm(), bound * found.norm()) << seed;
  }
}

/// At a wall that rubs and loses, too, where the map is not linear: velocity_after_kicks opens the next step
/// as the step itself does, in the geometries of node and middle.
TEST(Response, velocity_after_is_that_of_the_next_drift_at_a_wall_that_resists) {
  constexpr double h = 2e-3, bound = 1e-14;  // of the velocity
  DrillingSystem s = coupled_bit(AxialMode::load, DamperEnd::top);
  s.wall.restitution = 0.7;
  s = make_drilling_system(s);
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  DrillingVelocity v;
  Eigen::VectorXd predicted;
  for (int seed = 0; seed < 50; ++seed) {
    const Wrench w = some_wrench(seed);
    open_step(s, h, d, d.work);
    velocity_after_kicks(s, h, d, RemainingKicks::closing_and_opening, w, d.work, v);
    to_column(s, v, predicted);
    close_step(s, h, w, d, d.work);
    DrillingRun next = d;
    const Eigen::VectorXd found = velocity_of_next_drift(s, h, next);
    EXPECT_LT((predicted - found).norm(), bound * found.norm()) << seed;
    velocity_after_kicks(s, h, d, RemainingKicks::opening, w, d.work, v);
    to_column(s, v, predicted);
    EXPECT_LT((predicted - found).norm(), bound * found.norm()) << seed;
  }
}

/// A load on one freedom moves another as much as a load on that one moves the first: not quite,
/// since dampers act in turn.
TEST(Response, is_positive_and_nearly_symmetric) {
  const DrillingSystem s = linear_bit();
  DrillingRun d = start(s, smooth_law, coupled_start(s));
  const Response response = response_of(s, 1e-3, d);
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  const Matrix9 A = response.A, even = 0.5 * (A + A.transpose());
  EXPECT_LT((A - even).norm(), 5e-4 * even.norm());
  EXPECT_EQ(Eigen::LLT<Matrix9>(even).info(), Eigen::Success);
}

/// However light: any mass above 0 is one that moves.
TEST(Response, has_the_freedom_of_light_rock) {
  DrillingSystem s = plain_bit();
  s.rock.mass = 0.25;
  s = make_drilling_system(s);
  DrillingRun d = start(s, nullptr, at_rest(s));
  const Response response = response_of(s, 1e-3, d);
  ASSERT_EQ(response.free.size(), 7);
  EXPECT_NEAR(response.A(6, 6), 1e-3 / 0.25, 1e-15);
}

TEST(Response, leaves_out_rock_that_is_held) {
  const DrillingSystem s = plain_bit();
  DrillingRun d = start(s, nullptr, at_rest(s));
  const Response response = response_of(s, 1e-3, d);
  ASSERT_EQ(response.free.size(), 6);
  EXPECT_NEAR(response.A(2, 2), 1e-3 / s.mass, 1e-18);
}

}  // namespace tdbd::dynamics::response_test

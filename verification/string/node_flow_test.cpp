#include "string/node_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace tdbd::string::node_flow_test {

struct Node {
  Slip mass, damping, force;
  Coulomb friction;
};

FreeFlow free_flow(const Node& n, double time, const Slip& w) {
  FreeFlow f;
  f.mobility = {mobility(time, n.mass.along, n.damping.along),
                mobility(time, n.mass.around, n.damping.around)};
  f.speed = {w.along + f.mobility.along * (n.force.along - n.damping.along * w.along),
             w.around + f.mobility.around * (n.force.around - n.damping.around * w.around)};
  return f;
}

Slip flow(const Node& n, double time, const Slip& w) {
  return flow_slip(w, free_flow(n, time, w), n.friction);
}

double energy(const Node& n, const Slip& w) {
  return 0.5 * (n.mass.along * w.along * w.along + n.mass.around * w.around * w.around);
}

TEST(NodeFlow, energy_never_rises_without_a_force) {
  Random random{2007};
  const auto between = [&](double lo, double hi) {
    return lo * std::pow(hi / lo, random.uniform());
  };
  int raised = 0;
  for (int k = 0; k < 30000; ++k) {
    Node n;
    n.mass = {between(1.0, 1e4), between(1.0, 1e4)};
    n.damping = {between(1e-3, 1e4), between(1e-3, 1e4)};
    const double sliding = between(1.0, 1e5);
    n.friction = {sliding * between(1.0, 3.0), sliding, k % 3 == 0 ? 0.0 : between(1e-3, 1.0)};
    const double angle = 6.3 * random.uniform(), size = between(1e-6, 10.0);
    const Slip w{size * std::cos(angle), size * std::sin(angle)};
    raised += energy(n, flow(n, between(1e-6, 1e-2), w)) > energy(n, w) * (1.0 + 1e-15);
  }
  EXPECT_EQ(raised, 0);
}

/// A point whose slip turns while it slides, by flows of h and of h/2: observed order.
TEST(NodeFlow, turning_slip_is_of_second_order) {
  Node n{{3.0, 1.0}, {0.2, 0.1}, {4.0, -9.0}, {2.0, 2.0, 0.0}};
  const auto after = [&](int steps) {
    Slip w{1.0, 2.0};
    for (int k = 0; k < steps; ++k) w = flow(n, 0.3 / steps, w);
    return w;
  };
  const Slip exact = after(100000);
  const auto error = [&](int steps) {
    const Slip w = after(steps);
    return std::hypot(w.along - exact.along, w.around - exact.around);
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(error(80) / error(160)), 2.0, 0.1);
}

TEST(NodeFlow, steady_sliding_is_a_fixed_point) {
  for (const double scale : {1e-6, 1.0}) {  // slow: by the size equation; fast: far from rest
    Node n{{3.0, 1.0}, {0.2, 0.1}, {}, {2.0, 2.0, 0.0}};
    const Slip w{0.6 * scale, 0.8 * scale};
    n.force = {2.0 * 0.6 + 0.2 * w.along, 2.0 * 0.8 + 0.1 * w.around};
    const Slip end = flow(n, 1e-3, w);
    // What friction takes in a flow is up to 2e-3 m/s, 1000 times the slow slip.
    const double rounding = scale < 1.0 ? 4e-20 : 4e-16;
    EXPECT_NEAR(end.along, w.along, rounding);
    EXPECT_NEAR(end.around, w.around, rounding);
  }
}

TEST(NodeFlow, friction_at_rest_holds_exactly_and_lets_go_beyond) {
  Node n{{3.0, 1.0}, {0.2, 0.1}, {1.2, 1.59}, {2.0, 1.0, 0.0}};
  EXPECT_EQ(size_of(flow(n, 1e-3, {})), 0.0);
  n.force.around = 1.61;
  EXPECT_GT(size_of(flow(n, 1e-3, {})), 0.0);
}

/// One direction: the flow of a time is that of its halves, whatever is passed in between.
TEST(NodeFlow, one_direction_is_exact) {
  Random random{7};
  double worst = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const OneWay body{1.0, k % 4 == 0 ? 0.0 : random.uniform()};
    const double sliding = random.uniform();
    const Coulomb friction{sliding * (1.0 + random.uniform()), sliding,
                           k % 2 == 0 ? 0.0 : 0.3 * random.uniform()};
    const double force = 4.0 * random.uniform() - 2.0, start = 2.0 * random.uniform() - 1.0;
    const double whole = flow_along(body, force, friction, 2.0, start);
    double parts = start;
    for (int i = 0; i < 8; ++i) parts = flow_along(body, force, friction, 0.25, parts);
    worst = std::max(worst, std::abs(parts - whole));
  }
  EXPECT_LE(worst, 3e-14);
}

/// A body that friction brings to rest from w0: its energy and its way.
TEST(NodeFlow, what_came_to_rest_is_booked_to_the_end_of_its_way) {
  const Slip from{0.5, 0.0}, force{1.0, 0.0};
  Lost lost;
  book_flow({from, {0.0, 0.0}, force, 3.0, 1.0}, {2.0, 0.0}, {0.0, 0.0}, lost);
  const double way = 0.5 * 2.0 * 0.25 / (3.0 - 1.0);  // energy over what brakes
  EXPECT_DOUBLE_EQ(lost.friction, 3.0 * way);
}

}  // namespace tdbd::string::node_flow_test

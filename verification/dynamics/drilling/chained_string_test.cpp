#include "dynamics/drilling/chained_string.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/observed_order.hpp"
#include "rotation/quaternion.hpp"
#include "string/simple_bit.hpp"
#include "verification/battery/counted_memory.hpp"
#include "verification/dynamics/drilling/drilling_run.hpp"

/// A bit that forces move at the end of a chain of nodes.
namespace tdbd::dynamics::chained_string_test {
namespace {

constexpr double rate = 5e-3, speed = 12.0;        // m/s, rad/s, of the top
constexpr double bit_mass = 180.0, gravity = 9.8;  // kg, m/s2

/// Pipe above collars, in mud; with friction on the wall if `mu` > 0.
string::Chain chain_of(int elements, double mu = 0.0) {
  const string::Surroundings mud{1200.0, gravity};
  const std::vector<string::Section> sections{
      string::pipe(400.0, {0.127, 0.1086, 0.1682}, {}, 0.0, mud),
      string::pipe(100.0, {0.1651, 0.0714, 0.1651}, {}, 0.0, mud)};
  const string::Survey survey =
      string::make_survey({{0.0, 100.0, 300.0, 500.0}, {0.0, 0.0, 0.6, 0.6}, {0.0, 0.0, 0.4, 0.4}});
  string::Chain c;
  c.elements = string::make_elements(sections, elements);
  c.contact = string::make_contact(sections, survey, {{0.0, mu, mu}}, elements);
  return c;
}

/// A bit of 180 kg that hangs from the chain, with springs across.
struct Hanging {
  DrillingSystem system;
  DrillingState state;
  string::ChainState chain;
};

Hanging hanging(string::Chain c, const string::SteadyMotion& motion) {
  Hanging h;
  DrillingSystem& s = h.system;
  s.mass = bit_mass + c.elements.mass.back();
  s.gravity = gravity * bit_mass / s.mass + c.contact.weight.back() / s.mass;
  s.gyrostat = make_gyrostat(Vec3(80.0, 80.0, 2.0 + c.elements.inertia.back()).asDiagonal(), {});
  s.string.stiffness = Vec3(5e7, 5e7, c.elements.axial.back()).asDiagonal();
  s.string.turn_stiffness = Vec3(1e6, 1e6, c.elements.torsional.back()).asDiagonal();
  s.top.speed = dynamics::constant(speed);
  s.top.rate = dynamics::constant(rate);
  s.chained = ChainedString{std::move(c)};
  h.state.rotation =
      make_state(s.gyrostat, Mat3::Identity(), motion.rotary_speed * Vec3::UnitZ(), {}, {});
  h.state.momentum_W = s.mass * motion.rate * Vec3::UnitZ();
  start_chain(motion, s, h.state, h.chain);
  h.system = make_drilling_system(s);
  return h;
}

double weight_of(const Hanging& h) { return h.system.mass * h.system.gravity; }

DrillingRun started(const Hanging& h, const LumpedLaw& law) {
  DrillingRun d = go_on(h.system, start_drilling(h.system, h.state, h.chain));
  evaluate(h.system, law, d.state, d.wrench);
  return d;
}

/// Weight and torque that grow with the speeds, and beat.
void resist(const DrillingSystem&, const DrillingState& state, const DrillingVelocity& v,
            Wrench& w) {
  const double t = state.rotation.time;
  w.force_W = Vec3(300.0 * std::sin(20.0 * t), 200.0 * std::cos(31.0 * t),
                   -(8e3 + 2e5 * v.v_W.z() + 1e3 * std::sin(40.0 * t)));
  w.torque_W = Vec3(0.0, 0.0, -(900.0 + 20.0 * v.w_W.z() + 300.0 * std::sin(25.0 * t)));
}

double twist_of(const DrillingRun& d) {
  return rotation::twist_angle(d.state.rotation.q_WB, d.state.rotation.turns);
}

/// One element is the lumped string itself: its upper end is the top.
TEST(ChainedString, of_one_element_is_a_lumped_string) {
  constexpr double h = 5e-4, rounding = 1e-11;
  string::Chain c = chain_of(1);
  const Hanging one = hanging(c, {rate, speed, 10e3, 900.0});
  DrillingSystem lumped = one.system;
  lumped.chained.reset();
  lumped.top.start_angle = one.state.upper.angle;
  lumped = make_drilling_system(lumped);
  DrillingRun chained = started(one, resist), alone = start(lumped, resist, one.state);
  for (int i = 0; i < 4000; ++i) {
    step(one.system, resist, h, chained);
    step(lumped, resist, h, alone);
  }
  EXPECT_LT((chained.state.c_W - alone.state.c_W).norm(), rounding);
  EXPECT_LT((chained.state.momentum_W - alone.state.momentum_W).norm(),
            rounding * alone.state.momentum_W.norm() * 1e3);
  EXPECT_NEAR(twist_of(chained), twist_of(alone), rounding * 100.0);
  EXPECT_NEAR(chained.state.rotation.momentum_W.z(), alone.state.rotation.momentum_W.z(),
              rounding * 1e3 * std::abs(alone.state.rotation.momentum_W.z()));
}

/// Steady drilling with friction in the hole, in mud, is a fixed point: 1e4 steps.
TEST(ChainedString, keeps_steady_drilling) {
  constexpr double h = 5e-4, kept = 1e-8;
  string::Chain c = chain_of(50, 0.25);
  c.axial_damping = c.torsional_damping = 0.3;
  constexpr double weight = 30e3, torque = 2e3;
  const double own = gravity * bit_mass + c.contact.weight.back();
  const Hanging s = hanging(c, {rate, speed, own - weight, torque});
  const LumpedLaw law = [](const DrillingSystem&, const DrillingState&, const DrillingVelocity&,
                           Wrench& w) {
    w.force_W = Vec3(0.0, 0.0, -weight);
    w.torque_W = Vec3(0.0, 0.0, -torque);
  };
  DrillingRun d = started(s, law);
  const double twist = d.chain.angle[0];
  const auto stretch_of = [&] {
    return d.state.c_W.z() - s.system.string.rest_W.z() - d.chain.displacement[0];
  };
  const double stretch = stretch_of();
  for (int i = 0; i < 10000; ++i) step(s.system, law, h, d);
  EXPECT_NEAR((d.chain.angle[0] - twist_of(d)) / twist, 1.0, kept);
  EXPECT_NEAR(stretch_of() / stretch, 1.0, kept);
  for (const double v : d.chain.velocity) EXPECT_NEAR(v / rate, 1.0, kept);
  for (const double w : d.chain.rotary_speed) EXPECT_NEAR(w / speed, 1.0, kept);
  EXPECT_NEAR(weight_of(s) / own, 1.0, 1e-12);
}

/// Against the bit without a shape on the same chain, which has a step of its own: along the hole and
/// about it both are the same scheme, where no damper acts at the bit.
TEST(ChainedString, moves_a_bit_as_the_bit_without_a_shape_moves) {
  constexpr double h = 5e-4, rounding = 1e-10;
  const string::Chain c = chain_of(40, 0.2);
  const double own = gravity * bit_mass + c.contact.weight.back();
  const string::SteadyMotion motion{rate, speed, own - 20e3, 1500.0};
  const Hanging s = hanging(c, motion);
  const LumpedLaw law = [](const DrillingSystem&, const DrillingState&, const DrillingVelocity&,
                           Wrench& w) {
    w.force_W = Vec3(0.0, 0.0, -26e3);
    w.torque_W = Vec3(0.0, 0.0, -2500.0);
  };
  DrillingRun d = started(s, law);
  string::SimpleBit bit = string::bit_below(c, bit_mass, 2.0, gravity * bit_mass);
  bit.law = string::BitLaw::load;
  bit.weight = 26e3;
  bit.torque = 2500.0;
  string::BitOnChain other;
  other.chain = s.chain;
  other.bit.displacement = d.state.c_W.z() - s.system.string.rest_W.z();
  other.bit.velocity = rate;
  other.bit.rotary_speed = speed;
  string::ChainWork work = string::chain_work(c, other.chain, string::motion_of(other.bit));
  const string::TopCommand command{speed * h, rate * h, 0.0, 0.0};
  double twisted = 0.0;
  for (int i = 0; i < 2000; ++i) {
    step(s.system, law, h, d);
    string::step_bit_on_chain(c, bit, h, command, other, work);
    twisted = std::max(twisted, std::abs(d.chain.angle[0] - twist_of(d)));
  }
  EXPECT_GT(twisted, 1.0);
  EXPECT_NEAR(twist_of(d), other.bit.angle, rounding * 100.0);
  EXPECT_NEAR(d.state.c_W.z() - s.system.string.rest_W.z(), other.bit.displacement, rounding);
  for (std::size_t i = 0; i < d.chain.angle.size(); ++i) {
    EXPECT_NEAR(d.chain.angle[i], other.chain.angle[i], rounding * 100.0);
    EXPECT_NEAR(d.chain.velocity[i], other.chain.velocity[i], rounding);
  }
}

/// The residual of the ledger at one time, over five steps: with friction, mud, Kelvin-Voigt's dampers
/// off, and a top drive of its own inertia.
TEST(ChainedString, closes_the_ledger_with_order_2) {
  string::Chain c = chain_of(30, 0.2);
  c.axial_damping = c.torsional_damping = 0.3;
  c.top.torsion = string::Top::Torsion::pi;
  c.top.inertia = 1000.0;
  c.top.proportional = 400.0;
  c.top.integral = 900.0;
  Hanging s = hanging(c, {rate, speed, 10e3, 900.0});
  s.system.gravity_across = 5.0;
  std::vector<double> steps, residuals;
  for (const int n : {400, 800, 1600, 3200, 6400}) {
    DrillingRun d = started(s, resist);
    double largest = 0.0;
    for (int i = 0; i < n; ++i) {
      step(s.system, resist, 0.4 / n, d);
      if ((i + 1) % (n / 40) == 0) largest = std::max(largest, std::abs(residual(s.system, d)));
    }
    steps.push_back(0.4 / n);
    residuals.push_back(largest);
  }
  EXPECT_NEAR(least_squares_order(steps, residuals), 2.0, 0.1);
}

/// All state of bit and chain that a scheduled top does not prescribe.
std::vector<double> state_of(const DrillingRun& d) {
  std::vector<double> x{d.state.c_W.x(),
                        d.state.c_W.y(),
                        d.state.c_W.z(),
                        d.state.momentum_W.x(),
                        d.state.momentum_W.y(),
                        d.state.momentum_W.z(),
                        d.state.rotation.momentum_W.z(),
                        twist_of(d)};
  for (const auto* part :
       {&d.chain.displacement, &d.chain.velocity, &d.chain.angle, &d.chain.rotary_speed})
    x.insert(x.end(), part->begin() + 1, part->end());
  return x;
}

/// Under forces that depend on time and, not linearly, on velocities, across and along an inclined hole.
/// Every number of the state, the largest of its errors at ten times: differences from a step twelve
/// times shorter than the shortest.
TEST(ChainedString, converges_with_order_2_in_every_variable) {
  constexpr double duration = 0.2, deviation = 0.06;
  constexpr int finest = 1600, times = 10;
  string::Chain c = chain_of(8);
  c.axial_damping = c.torsional_damping = 0.3;
  Hanging s = hanging(c, {rate, speed, 10e3, 900.0});
  s.system.gravity_across = 5.0;
  s.system = make_drilling_system(s.system);
  const LumpedLaw law = [](const DrillingSystem&, const DrillingState& state,
                           const DrillingVelocity& v, Wrench& w) {
    const double t = state.rotation.time, down = v.v_W.z();
    w.force_W = Vec3(300.0 * std::sin(20.0 * t), 200.0 * std::cos(31.0 * t),
                     -(8e3 + 2e5 * down * (1.0 + 10.0 * down)));
    w.torque_W = Vec3(0.0, 0.0, -(900.0 + 20.0 * v.w_W.z() + v.w_W.z() * v.w_W.z()));
  };
  const auto run = [&](int n) {
    DrillingRun d = started(s, law);
    std::vector<std::vector<double>> states;
    for (int i = 1; i <= n; ++i) {
      step(s.system, law, duration / n, d);
      if (i % (n / times) == 0) states.push_back(state_of(d));
    }
    return states;
  };
  const auto exact = run(12 * finest);
  std::vector<double> steps;
  std::vector<std::vector<double>> errors(exact[0].size());
  for (int n = finest / 16; n <= finest; n *= 2) {
    const auto found = run(n);
    steps.push_back(duration / n);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      double largest = 0.0;
      for (std::size_t k = 0; k < times; ++k)
        largest = std::max(largest, std::abs(found[k][i] - exact[k][i]));
      errors[i].push_back(largest);
    }
  }
  for (std::size_t i = 0; i < errors.size(); ++i)
    EXPECT_NEAR(least_squares_order(steps, errors[i]), 2.0, deviation) << i;
}

/// Across an inclined hole the bit swings about where its springs bear its weight, and settles there.
TEST(ChainedString, sags_to_the_low_side_by_its_weight_over_the_lateral_stiffness) {
  constexpr double rounding = 1e-12;
  Hanging s = hanging(chain_of(10), {0.0, 0.0, 10e3, 0.0});
  s.system.top.speed = s.system.top.rate = dynamics::constant(0.0);
  s.system.gravity_across = 8.0;
  s.system.string.damping = Vec3(6e4, 6e4, 0.0).asDiagonal();
  s.system = make_drilling_system(s.system);
  const LumpedLaw nothing = [](const DrillingSystem&, const DrillingState&, const DrillingVelocity&,
                               Wrench&) {};
  DrillingRun d = started(s, nothing);
  const Vec3 from = d.state.c_W;
  const double sag = 8.0 * s.system.mass / s.system.string.stiffness(0, 0);
  double furthest = 0.0;
  for (int i = 0; i < 8000; ++i) {
    step(s.system, nothing, 5e-4, d);
    furthest = std::max(furthest, d.state.c_W.x() - from.x());
  }
  EXPECT_NEAR(d.state.c_W.x() - from.x(), sag, rounding);
  EXPECT_EQ(d.state.c_W.y(), from.y());
  EXPECT_GT(furthest, 1.5 * sag);
}

/// A restart between two steps continues bitwise, and a step that is warm allocates nothing.
TEST(ChainedString, continues_bitwise_identical_and_allocates_nothing) {
  string::Chain c = chain_of(30, 0.2);
  c.torsional_loss_time = 5e-5;
  const Hanging s = hanging(c, {rate, speed, 10e3, 900.0});
  DrillingRun whole = started(s, resist);
  for (int i = 0; i < 50; ++i) step(s.system, resist, 5e-4, whole);
  DrillingRun again = go_on(s.system, whole);
  for (int i = 0; i < 50; ++i) {
    step(s.system, resist, 5e-4, whole);
    step(s.system, resist, 5e-4, again);
  }
  EXPECT_EQ(whole.chain.angle, again.chain.angle);
  EXPECT_EQ(whole.chain.velocity, again.chain.velocity);
  EXPECT_EQ(whole.state.c_W, again.state.c_W);
  EXPECT_EQ(whole.state.rotation.momentum_W, again.state.rotation.momentum_W);
  EXPECT_EQ(whole.ledger.chain_loss, again.ledger.chain_loss);
  Wrench wrench = whole.wrench;
  battery::reset_peak();
  const long held = battery::counted_memory().held;
  for (int i = 0; i < 100; ++i) {
    open_step(s.system, 5e-4, whole, whole.work);
    close_step(s.system, 5e-4, wrench, whole, whole.work);
  }
  EXPECT_EQ(battery::counted_memory().peak, held);
}

}  // namespace
}  // namespace tdbd::dynamics::chained_string_test

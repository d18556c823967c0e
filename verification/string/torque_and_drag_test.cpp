#include "reference/string/torque_and_drag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/types.hpp"
#include "string/section.hpp"
#include "string/side_force.hpp"
#include "string/statics.hpp"
#include "verification/battery/refused_call.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::torque_and_drag_test {

/// Loads of a well by the differential equations of a soft string, N and N m.
struct Loads {
  double up, down, rotating, torque;
};

/// Published and computed by two programs apart.
constexpr Loads plain{519.3804e3, 297.6135e3, 386.7841e3, 9.07152e3};
constexpr Loads composed{624.3936e3, 322.9487e3, 443.1863e3, 12.31415e3};

reference::DraggedString twin_of(const std::vector<Section>& sections) {
  reference::DraggedString d;
  for (const Section& s : sections) d.sections.push_back({s.length, s.weight, s.contact_radius});
  d.stations = {{0.0, 0.0, 0.0},
                {500.0, 0.0, 0.0},
                {1100.0, 60.0 * degree, 0.0},
                {2500.0, 60.0 * degree, 0.0}};
  d.friction = 0.25;
  return d;
}

Loads by_quadrature(const std::vector<Section>& sections) {
  const reference::DraggedString d = twin_of(sections);
  const double step = 0.5;
  const auto rotating = reference::dragged_load(d, {0.0, 1.0, 0.0, 0.0}, 0.0, step);
  return {reference::dragged_load(d, {-1.0, 0.0, 0.0, 0.0}, 0.0, step).tension,
          reference::dragged_load(d, {1.0, 0.0, 0.0, 0.0}, 0.0, step).tension, rotating.tension,
          rotating.torque};
}

SteadyLoad moving(const Chain& c, double rate, double speed, double weight = 0.0,
                  double torque = 0.0) {
  return steady_load(c, {rate, speed, c.contact.weight.back() - weight, torque});
}

Loads by_chain(const Chain& c) {
  const SteadyLoad rotating = moving(c, 0.0, 60.0 * rpm);
  return {moving(c, -0.2, 0.0).surface.hook_load, moving(c, 0.2, 0.0).surface.hook_load,
          rotating.surface.hook_load, rotating.surface.torque};
}

/// Largest relative error of hook loads, and that of the torque.
std::pair<double, double> errors(const Loads& found, const Loads& exact) {
  return {std::max({std::abs(found.up / exact.up - 1.0), std::abs(found.down / exact.down - 1.0),
                    std::abs(found.rotating / exact.rotating - 1.0)}),
          std::abs(found.torque / exact.torque - 1.0)};
}

TEST(TorqueAndDrag, quadrature_has_the_published_loads) {
  const double digits = 5e-7;  // half of the last one of 12.31415
  const auto [hook, torque] = errors(by_quadrature(plain_build_and_hold()), plain);
  const auto [hook_3, torque_3] = errors(by_quadrature(three_sections()), composed);
  EXPECT_LE(std::max({hook, torque, hook_3, torque_3}), digits);
}

TEST(TorqueAndDrag, build_and_hold_has_the_loads_of_a_soft_string) {
  for (const auto& sections : {plain_build_and_hold(), three_sections()}) {
    const Loads exact = by_quadrature(sections);
    const auto fine = errors(by_chain(make_chain(sections, build_and_hold(), 0.25, 250)), exact);
    const auto coarse = errors(by_chain(make_chain(sections, build_and_hold(), 0.25, 125)), exact);
    EXPECT_LE(fine.first, 1.5e-6);
    EXPECT_LE(fine.second, 6e-6);
    EXPECT_NEAR(std::log2(coarse.second / fine.second), 2.0, 0.02);
  }
}

TEST(TorqueAndDrag, weight_and_torque_on_bit_reach_the_surface) {
  const Chain c = make_chain(three_sections(), build_and_hold(), 0.25, 250);
  const SteadyLoad drilling = moving(c, 0.0, 60.0 * rpm, 80e3, 4e3);
  EXPECT_NEAR(drilling.surface.hook_load / 363.1863e3, 1.0, 1e-7);
  EXPECT_NEAR(drilling.surface.torque / 14.55276e3, 1.0, 6e-6);
}

/// A well whose path turns in azimuth as well, both speeds at once, loads over depth. The first element
/// differs: node 0 leaves its friction to node 1.
TEST(TorqueAndDrag, profiles_of_a_path_in_space_are_those_of_quadrature) {
  const Stations path{{0.0, 300.0, 900.0, 1500.0},
                      {0.0, 5.0 * degree, 50.0 * degree, 80.0 * degree},
                      {0.0, 20.0 * degree, 70.0 * degree, 150.0 * degree}};
  const std::vector<Section> sections{steel(1950.0, 0.127, 0.1086, 0.1682),
                                      steel(50.0, 0.1651, 0.0714)};
  reference::DraggedString d = twin_of(sections);
  d.stations.clear();
  for (std::size_t i = 0; i < path.depths.size(); ++i)
    d.stations.push_back({path.depths[i], path.inclinations[i], path.azimuths[i]});
  const auto worst = [&](int elements) {
    const Chain c = make_chain(sections, make_survey(path), 0.25, elements);
    const SteadyLoad load = steady_load(c, {0.3, 5.0, c.contact.weight.back() - 20e3, 1500.0});
    Loads most{};
    for (int e = elements / 40; e < elements; e += elements / 40) {
      const auto exact = reference::dragged_load(d, {0.3, 5.0, -20e3, 1500.0},
                                                 (e + 0.5) * c.elements.length, 0.25);
      most.up = std::max(most.up, std::abs(load.tension[at(e)] - exact.tension));
      most.torque = std::max(most.torque, std::abs(load.torque[at(e)] - exact.torque));
    }
    return most;
  };
  const Loads coarse = worst(400), fine = worst(800);
  EXPECT_LE(coarse.up, 0.4);       // of 246 kN
  EXPECT_LE(coarse.torque, 0.04);  // of 8.2 kN m
  EXPECT_NEAR(std::log2(coarse.up / fine.up), 2.0, 0.15);
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// Tension T and weight w in a circular arc: per length |w sin(inc) - T/R| where it builds.
double force_on_arc(int elements) {
  const Survey survey = build_and_hold();
  const auto sections = plain_build_and_hold();
  const Contact c = make_contact(sections, survey, {}, elements);
  std::vector<double> force(at(elements) + 1);
  side_forces(c, std::vector<double>(at(elements), 2e5), force);
  return sum(force);
}

TEST(SideForce, of_constant_tension_over_a_well_is_the_integral_by_arc_length) {
  const double T = 2e5, R = 600.0 / (60.0 * degree), w = plain_build_and_hold()[0].weight;
  const int steps = 200000;
  double exact = 1400.0 * w * std::sin(60.0 * degree);
  for (int i = 0; i < steps; ++i)
    exact += 600.0 / steps * std::abs(w * std::sin(60.0 * degree * (i + 0.5) / steps) - T / R);
  const double coarse = force_on_arc(125) / exact - 1.0, fine = force_on_arc(250) / exact - 1.0;
  EXPECT_LE(std::abs(fine), 3e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3);
}

TEST(SideForce, weights_along_the_hole_add_up_to_the_fall_of_the_well) {
  const Contact c = make_contact(plain_build_and_hold(), build_and_hold(), {}, 37);
  const double fall = position_at(build_and_hold(), 2500.0).z();
  EXPECT_NEAR(sum(c.weight) / (plain_build_and_hold()[0].weight * fall), 1.0, 2e-15);
}

TEST(SideForce, friction_changes_with_depth_inside_an_element) {
  const Contact c =
      make_contact({drill_pipe(100.0)}, vertical(), {{0.0, 0.2, 0.1}, {53.0, 0.4, 0.3}}, 10);
  EXPECT_DOUBLE_EQ(c.resting[4], 0.2);
  EXPECT_NEAR(c.resting[5], 0.2 * 0.8 + 0.4 * 0.2, 1e-15);
  EXPECT_NEAR(c.sliding[6], 0.3, 1e-15);
}

TEST(SideForce, both_ends_leave_their_friction_to_the_nodes_beside_them) {
  const Contact c = make_contact(plain_build_and_hold(), build_and_hold(), {{0.0, 0.3, 0.3}}, 50);
  EXPECT_EQ(c.resting.front(), 0.0);
  EXPECT_EQ(c.resting.back(), 0.0);
  EXPECT_EQ(c.node.front(), 1);
  EXPECT_EQ(c.node.back(), 49);
}

}  // namespace tdbd::string::torque_and_drag_test

namespace tdbd::string::off_bottom_test {

/// Well A of Aarsnes and Shor, deviated: vertical to 1500 m, 60 deg from 2100 m on. The string turns
/// without tension, its side force is that of the weight alone.
Chain deviated_well(double resting, double sliding, double threshold, int elements) {
  const Survey survey = make_survey({{0.0, 1500.0, 2100.0, 2500.0},
                                     {0.0, 0.0, 60.0 * degree, 60.0 * degree},
                                     {0.0, 0.0, 0.0, 0.0}});
  const auto sections = well_a_sections();
  Chain c;
  c.directions = Directions::torsion;
  c.elements = make_elements(sections, elements);
  c.contact = make_contact(sections, survey, {{0.0, resting, sliding}}, elements);
  c.threshold = threshold;
  return c;
}

/// Torque and turn of the top of a slowly turned string when its bit first moves: friction per length
/// summed from the bit up, and the twist that it makes.
struct BreakAway {
  double torque, turn;
};
BreakAway by_quadrature(double friction) {
  const auto sections = well_a_sections();
  const double h = 0.25;
  double torque = 0.0, turn = 0.0;
  for (double s = 2500.0 - 0.5 * h; s > 0.0; s -= h) {
    const Section& here = sections[s > 2270.0 ? 1 : 0];
    const double inclination = 60.0 * degree * std::clamp((s - 1500.0) / 600.0, 0.0, 1.0);
    const double part = friction * here.weight * std::sin(inclination) * here.contact_radius * h;
    torque += 0.5 * part;
    turn += torque * h / here.torsional_rigidity;
    torque += 0.5 * part;
  }
  return {torque, turn};
}

TEST(OffBottom, a_slowly_turned_string_breaks_away_with_all_its_friction) {
  const BreakAway exact = by_quadrature(0.4);
  EXPECT_NEAR(exact.torque, 12.8528e3, 8.0);
  EXPECT_NEAR(exact.turn, 20.191, 0.01);
  const Chain c = deviated_well(0.4, 0.4, 0.0, 250);
  const SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  const double h = 2e-3, speed = 0.5 * rpm;
  Running r = at_rest(c);
  TopCommand command;
  command.turn = speed * h;
  long k = 0;
  for (; r.state.bit.angle == 0.0 && k < 1000000; ++k)
    step_bit_on_chain(c, bit, h, command, r.state, r.work);
  const double turn = speed * h * static_cast<double>(k);
  EXPECT_NEAR(r.work.torque[0] / exact.torque, 1.0, 2e-3);
  EXPECT_NEAR(turn / exact.turn, 1.0, 2e-3);
}

/// Mean time between starts of the bit from 80 s to 160 s.
double period(double friction, double ratio, double top_speed, int elements, double loss) {
  Chain c = deviated_well(friction, ratio * friction, 0.0, elements);
  c.threshold = 1.0 * well_a_sections()[0].contact_radius;  // 1 rad/s
  c.torsional_damping = 0.1;
  c.top.torsion = Top::Torsion::pi;
  c.top.inertia = 2900.0;
  c.top.proportional = 38e3;
  c.top.integral = 100e3;
  const double h = 0.56 * c.elements.length / 2788.0;
  c.torsional_loss_time = loss * h;
  const SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  Running r = at_rest(c);
  TopCommand command;
  command.turn = top_speed * h;
  const double mean = top_speed;
  double first = -1.0, last = -1.0;
  int starts = -1;
  double standing = 0.0;  // s, in which it has hardly moved
  for (long k = 0; static_cast<double>(k) * h < 160.0; ++k) {
    step_bit_on_chain(c, bit, h, command, r.state, r.work);
    const double t = static_cast<double>(k) * h, omega = r.state.bit.rotary_speed;
    if (omega < mean) {
      if (omega < 0.3 * mean) standing += h;
      continue;
    }
    const bool starts_now = standing > 0.5;
    standing = 0.0;
    if (t < 80.0 || !starts_now) continue;
    last = t;
    if (++starts == 0) first = t;
  }
  return (last - first) / starts;
}

TEST(OffBottom, friction_that_falls_makes_the_bit_stop_and_go_with_the_known_period) {
  // Found by three independent schemes. On finer grids with little loss the bit rings as it starts.
  EXPECT_NEAR(period(0.3, 0.3, 20.0 * rpm, 125, 0.1) / 8.79, 1.0, 0.01);
  EXPECT_NEAR(period(0.3, 0.5, 60.0 * rpm, 125, 0.1) / 5.55, 1.0, 0.015);
}

const double rounding = 1e-15;

Survey turning() {
  return make_survey({{0.0, 300.0, 900.0, 1500.0},
                      {0.0, 5.0 * degree, 50.0 * degree, 80.0 * degree},
                      {0.0, 20.0 * degree, 70.0 * degree, 150.0 * degree}});
}

TEST(Survey, tangents_at_stations_are_those_of_the_survey) {
  const Survey s = turning();
  const Vec3 t = tangent_at(s, 900.0 - 1e-9);
  EXPECT_NEAR(t.z(), std::cos(50.0 * degree), 3e-12);
  EXPECT_NEAR(std::atan2(t.y(), t.x()), 70.0 * degree, 3e-12);
  for (double depth = 0.0; depth < 2000.0; depth += 7.3)
    EXPECT_NEAR(tangent_at(s, depth).norm(), 1.0, 2.0 * rounding);
}

/// Positions by the formula of the ratio factor (Zaremba).
TEST(Survey, positions_are_those_of_minimum_curvature) {
  const Survey s = turning();
  const auto t = [](double inc, double azi) {
    return Vec3(std::sin(inc) * std::cos(azi), std::sin(inc) * std::sin(azi), std::cos(inc));
  };
  const Vec3 a = t(5.0 * degree, 20.0 * degree), b = t(50.0 * degree, 70.0 * degree);
  const double angle = std::acos(a.dot(b));
  const Vec3 step = 300.0 * (a + b) * (2.0 / angle) * std::tan(0.5 * angle);
  EXPECT_NEAR((position_at(s, 900.0) - position_at(s, 300.0) - step).norm(), 0.0, 5e-13);
}

TEST(Survey, positions_are_integrals_of_tangents_also_beyond_the_last_station) {
  const Survey s = turning();
  Vec3 sum = Vec3::Zero();
  const int n = 20000;
  const double l = 1800.0 / n;
  for (int i = 0; i < n; ++i) sum += l * tangent_at(s, (i + 0.5) * l);
  EXPECT_NEAR((position_at(s, 1800.0) - sum).norm(), 0.0, 1.5e-6);
}

TEST(Survey, rejects_stations_that_make_no_path) {
  const auto refused = [](Stations s, const char* part) {
    EXPECT_NE(survey_problem(s).find(part), std::string::npos) << survey_problem(s);
  };
  refused({{0.0, 10.0}, {0.0}, {0.0}}, "2 depths, 1 inclinations, 1 azimuths");
  refused({{5.0}, {0.0}, {0.0}}, "the first station is at 0 m");
  refused({{0.0, 10.0, 10.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, "station 3 at 10 m after 10 m");
  refused({{0.0, 10.0}, {0.0, 3.2}, {0.0, 0.0}}, "at most 180 deg");
  refused({{0.0, 1e3}, {0.5, 3.141592653589793 - 0.5}, {0.0, 3.141592653589793}}, "opposite");
  EXPECT_EQ(survey_problem({{0.0, 10.0}, {0.0, 0.1}, {0.0, 0.0}}), "");
}

TEST(Survey, finds_the_worst_dogleg) {
  const Dogleg d = worst_dogleg({{0.0, 500.0, 1100.0, 2500.0}, {0.0, 0.0, 1.0, 1.2}, {0, 0, 0, 0}});
  EXPECT_EQ(d.station, 3);
  EXPECT_NEAR(d.severity, 1.0 / 600.0, 1e-18);
}

}  // namespace tdbd::string::off_bottom_test

#include "reference/string/torque_and_drag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types.hpp"
#include "string/statics.hpp"
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

}  // namespace tdbd::string::torque_and_drag_test

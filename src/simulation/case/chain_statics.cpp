#include "simulation/case/chain_statics.hpp"

#include <algorithm>

namespace tdbd::simulation {

std::vector<StaticLoad> static_loads(const string::Chain& chain, double hanging,
                                     const string::SteadyMotion& start) {
  string::Chain c = chain;
  c.axial_damping = c.torsional_damping = 0.0;
  c.threshold = 0.0;
  std::vector<StaticLoad> loads;
  const auto add = [&](const char* name, const string::SteadyMotion& m) {
    loads.push_back({name, string::steady_load(c, m)});
  };
  if (c.directions != string::Directions::torsion) {
    add("pull_up", {-1.0, 0.0, hanging, 0.0});
    add("slack_off", {1.0, 0.0, hanging, 0.0});
  }
  if (c.directions != string::Directions::axial) add("rotate", {0.0, 1.0, hanging, 0.0});
  if (start.pull != hanging || start.torque != 0.0)
    add("drill", {0.0, 1.0, start.pull, start.torque});
  return loads;
}

ChainModes chain_modes(const string::Chain& chain, double mass, double inertia) {
  constexpr int count = 3;
  std::vector<double> masses = chain.elements.mass, inertias = chain.elements.inertia;
  masses.back() = mass;
  inertias.back() = inertia;
  ChainModes m;
  if (chain.directions != string::Directions::torsion)
    m.axial = string::lowest_modes(chain.elements.axial, masses, count);
  if (chain.directions != string::Directions::axial)
    m.torsional = string::lowest_modes(chain.elements.torsional, inertias, count);
  return m;
}

CourantNumbers courant_numbers(const std::vector<string::Section>& sections, double element_length,
                               double step) {
  CourantNumbers fastest;  // m/s
  for (const string::Section& s : sections) {
    if (s.mass > 0.0) fastest.axial = std::max(fastest.axial, string::axial_wave_speed(s));
    if (s.inertia > 0.0)
      fastest.torsional = std::max(fastest.torsional, string::torsional_wave_speed(s));
  }
  const double per_step = step / element_length;
  return {fastest.axial * per_step, fastest.torsional * per_step};
}

}  // namespace tdbd::simulation

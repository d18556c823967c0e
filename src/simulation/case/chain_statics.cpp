#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"
#include "simulation/case/read_chain.hpp"

namespace tdbd::simulation {
namespace {

void doubt_buckling(const Config& c, const DoubtfulChain& d, std::vector<CaseWarning>& warnings) {
  if (d.hole_diameter == 0.0) return;
  const char* key = d.string.hole_diameter > 0.0 ? "string.hole_diameter" : "string.model";
  for (const StaticLoad& l : d.loads) {
    for (int e = 0; e < d.chain.count(); ++e) {
      const double top = e * d.chain.elements.length, bottom = top + d.chain.elements.length;
      const string::Section& here =
          *string::spans_between(d.string.sections, top, bottom)[0].section;
      const double side =
          string::tangent_at(d.string.survey, bottom).head<2>().norm() * here.weight;
      const double clearance = std::max(0.5 * d.hole_diameter - here.contact_radius, 1e-3);
      const double limit = 2.0 * std::sqrt(here.bending_rigidity * side / clearance);
      if (side == 0.0 || l.load.tension[at(e)] > -limit) continue;
      warnings.push_back(
          {c.place(key), key,
           fmt::format("{}: compressed with {:.3g} kN at {:.0f} m, beyond sinusoidal buckling at "
                       "{:.3g} kN, which is not modelled",
                       l.name, -1e-3 * l.load.tension[at(e)], top, 1e-3 * limit)});
      break;
    }
  }
}

/// m/s; torsional waves are slower than axial waves.
double slowest_wave(const std::vector<string::Section>& sections) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const string::Section& s : sections)
    if (s.inertia > 0.0) slowest = std::min(slowest, string::torsional_wave_speed(s));
  return slowest;
}

void doubt_elements(const Config& c, const DoubtfulChain& d, std::vector<CaseWarning>& warnings) {
  constexpr double elements_per_wavelength = 10.0;
  constexpr const char* key = "string.element_length";
  const double wave = slowest_wave(d.string.sections) / elements_per_wavelength;
  const double length = d.chain.elements.length, resolved = wave / length;
  if (d.chain.count() < 2 || d.passing_frequency <= resolved) return;
  warnings.push_back(
      {c.place(key), key,
       fmt::format(
           "elements of {:.3g} m resolve waves up to {:.3g} Hz, {} elements to a wavelength; "
           "the blades of the bit pass at {:.3g} Hz: use at most {:.3g} m",
           length, resolved, elements_per_wavelength, d.passing_frequency,
           wave / d.passing_frequency)});
}

}  // namespace

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

std::vector<CaseWarning> chain_warnings(const Config& c, const DoubtfulChain& doubtful) {
  std::vector<CaseWarning> warnings;
  doubt_buckling(c, doubtful, warnings);
  doubt_elements(c, doubtful, warnings);
  return warnings;
}

}  // namespace tdbd::simulation

#include "simulation/case/chain_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"

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

/// m/s; those of torsion are slower than those along the string.
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

std::vector<CaseWarning> chain_warnings(const Config& c, const DoubtfulChain& doubtful) {
  std::vector<CaseWarning> warnings;
  doubt_buckling(c, doubtful, warnings);
  doubt_elements(c, doubtful, warnings);
  return warnings;
}

}  // namespace tdbd::simulation

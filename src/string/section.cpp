#include "string/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/types.hpp"

namespace tdbd::string {

Section pipe(double length, const Diameters& d, const Material& m, double linear_mass,
             const Surroundings& around) {
  using std::numbers::pi;
  const double area = pi / 4.0 * (d.outer * d.outer - d.inner * d.inner);
  const double polar = pi / 32.0 * (std::pow(d.outer, 4) - std::pow(d.inner, 4));
  const double heavier = linear_mass > 0.0 ? linear_mass / (m.density * area) : 1.0;
  Section s;
  s.length = length;
  s.axial_rigidity = m.young * area;
  s.torsional_rigidity = m.shear * polar;
  s.mass = heavier * m.density * area;
  s.inertia = heavier * m.density * polar;
  s.weight = s.mass * around.gravity * (1.0 - around.mud_density / m.density);
  s.contact_radius = 0.5 * d.contact;
  s.bending_rigidity = 0.5 * m.young * polar;
  return s;
}

double total_length(const std::vector<Section>& sections) {
  double length = 0.0;
  for (const Section& s : sections) length += s.length;
  return length;
}

std::vector<Span> spans_between(const std::vector<Section>& sections, double top, double bottom) {
  std::vector<Span> spans;
  double start = 0.0;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const bool last = k + 1 == sections.size();  // rounding must not cut off the end of the string
    const double end = start + sections[k].length;
    const double lo = std::max(top, start), hi = last ? bottom : std::min(bottom, end);
    if (hi > lo) spans.push_back({lo, hi, &sections[k]});
    start = end;
  }
  return spans;
}

Elements make_elements(const std::vector<Section>& sections, int count) {
  const double total = total_length(sections);
  const auto place = [&](double i) { return total * i / count; };
  Elements e;
  e.length = total / count;
  for (int i = 0; i < count; ++i) {
    double stretch = 0.0, twist = 0.0;
    for (const Span& s : spans_between(sections, place(i), place(i + 1))) {
      stretch += (s.bottom - s.top) / s.section->axial_rigidity;
      twist += (s.bottom - s.top) / s.section->torsional_rigidity;
    }
    e.axial.push_back(1.0 / stretch);
    e.torsional.push_back(1.0 / twist);
  }
  for (int i = 0; i <= count; ++i) {
    double mass = 0.0, inertia = 0.0;
    for (const Span& s : spans_between(sections, place(std::max(i - 0.5, 0.0)),
                                       place(std::min(i + 0.5, static_cast<double>(count))))) {
      mass += (s.bottom - s.top) * s.section->mass;
      inertia += (s.bottom - s.top) * s.section->inertia;
    }
    e.mass.push_back(mass);
    e.inertia.push_back(inertia);
  }
  return e;
}

double torsional_impedance(const Section& s) { return std::sqrt(s.torsional_rigidity * s.inertia); }

double axial_wave_speed(const Section& s) { return std::sqrt(s.axial_rigidity / s.mass); }

double torsional_wave_speed(const Section& s) {
  return std::sqrt(s.torsional_rigidity / s.inertia);
}

}  // namespace tdbd::string

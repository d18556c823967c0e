#include "string/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

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

namespace {

using std::numbers::pi;

Vec3 tangent_of(double inclination, double azimuth) {
  return {std::sin(inclination) * std::cos(azimuth), std::sin(inclination) * std::sin(azimuth),
          std::cos(inclination)};
}

Vec3 tangent_of(const Stations& s, std::size_t i) {
  return tangent_of(s.inclinations[i], s.azimuths[i]);
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

const Survey::Arc& arc_at(const Survey& s, double depth) {
  const auto above = std::upper_bound(s.arcs.begin() + 1, s.arcs.end(), depth,
                                      [](double d, const Survey::Arc& a) { return d < a.depth; });
  return *(above - 1);
}

}  // namespace

std::string survey_problem(const Stations& s) {
  constexpr double no_plane = 1e-6;  // rad, distance from half a turn
  const std::size_t n = s.depths.size();
  if (n == 0 || s.inclinations.size() != n || s.azimuths.size() != n)
    return fmt::format(
        "{} depths, {} inclinations, {} azimuths: the numbers must be equal and at least one", n,
        s.inclinations.size(), s.azimuths.size());
  if (s.depths[0] != 0.0)
    return fmt::format("station 1 at {} m: the first station is at 0 m", s.depths[0]);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0 && !(s.depths[i] > s.depths[i - 1]))
      return fmt::format("station {} at {} m after {} m: depths ascend", i + 1, s.depths[i],
                         s.depths[i - 1]);
    if (!(s.inclinations[i] >= 0.0 && s.inclinations[i] <= pi))
      return fmt::format(
          "station {} with an inclination of {:.6g} deg: at least 0, at most 180 deg", i + 1,
          s.inclinations[i] * 180.0 / pi);
    if (i > 0 && angle_between(tangent_of(s, i - 1), tangent_of(s, i)) > pi - no_plane)
      return fmt::format(
          "station {} points opposite to the one above: the plane of the arc is undefined", i + 1);
  }
  return {};
}

Dogleg worst_dogleg(const Stations& s) {
  Dogleg worst;
  for (std::size_t i = 1; i < s.depths.size(); ++i) {
    const double severity =
        angle_between(tangent_of(s, i - 1), tangent_of(s, i)) / (s.depths[i] - s.depths[i - 1]);
    if (severity > worst.severity) worst = {static_cast<int>(i) + 1, severity};
  }
  return worst;
}

Survey make_survey(const Stations& s) {
  if (const std::string why = survey_problem(s); !why.empty()) throw InputError(why);
  Survey survey;
  for (std::size_t i = 0; i < s.depths.size(); ++i) {
    Survey::Arc arc;
    arc.depth = s.depths[i];
    arc.tangent = tangent_of(s, i);
    if (i > 0) arc.position = position_at(survey, arc.depth);
    if (i + 1 < s.depths.size()) {
      const Vec3 next = tangent_of(s, i + 1);
      const Vec3 across = next - next.dot(arc.tangent) * arc.tangent;
      if (const double size = across.norm(); size > 0.0) {
        arc.normal = across / size;
        arc.curvature = angle_between(arc.tangent, next) / (s.depths[i + 1] - arc.depth);
      }
    }
    survey.arcs.push_back(arc);
  }
  return survey;
}

Survey vertical() { return make_survey({{0.0}, {0.0}, {0.0}}); }

Vec3 tangent_at(const Survey& survey, double depth) {
  const Survey::Arc& a = arc_at(survey, depth);
  const double turned = a.curvature * (depth - a.depth);
  return std::cos(turned) * a.tangent + std::sin(turned) * a.normal;
}

Vec3 position_at(const Survey& survey, double depth) {
  const Survey::Arc& a = arc_at(survey, depth);
  const double way = depth - a.depth;
  if (a.curvature == 0.0) return a.position + way * a.tangent;
  const double turned = a.curvature * way, half = std::sin(0.5 * turned);
  return a.position + (std::sin(turned) * a.tangent + 2.0 * half * half * a.normal) / a.curvature;
}

}  // namespace tdbd::string

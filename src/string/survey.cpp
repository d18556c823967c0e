#include "string/survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::string {
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

#include "reference/string/torque_and_drag.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

Vec3 unit(const DraggedStation& s) {
  return {std::sin(s.inclination) * std::cos(s.azimuth),
          std::sin(s.inclination) * std::sin(s.azimuth), std::cos(s.inclination)};
}

/// Tangent and its derivative along the hole, by spherical interpolation.
struct Path {
  Vec3 tangent, bend;
};
Path path_at(const std::vector<DraggedStation>& stations, double s, double from_below) {
  std::size_t k = 0;
  while (k + 1 < stations.size() && stations[k + 1].depth < s - from_below) ++k;
  if (k + 1 == stations.size()) return {unit(stations[k]), Vec3::Zero()};
  const Vec3 a = unit(stations[k]), b = unit(stations[k + 1]);
  const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0));
  const double length = stations[k + 1].depth - stations[k].depth;
  if (angle < 1e-9) return {a, Vec3::Zero()};
  const double x = (s - stations[k].depth) / length;
  const double p = (1.0 - x) * angle, q = x * angle, size = std::sin(angle);
  return {(std::sin(p) * a + std::sin(q) * b) / size,
          (std::cos(q) * b - std::cos(p) * a) * (angle / length / size)};
}

/// d/ds of tension and torque in a section.
DraggedLoad slope(const DraggedString& d, const DraggedMotion& m, const DraggedSection& section,
                  double s, double from_below, const DraggedLoad& load) {
  const Path path = path_at(d.stations, s, from_below);
  const Vec3 down = Vec3::UnitZ();
  const Vec3 push =
      load.tension * path.bend + section.weight * (down - down.dot(path.tangent) * path.tangent);
  const double slip = std::hypot(m.rate, m.speed * section.radius);
  const double drag = slip > 0.0 ? d.friction * push.norm() / slip : 0.0;
  return {-section.weight * path.tangent.z() + drag * m.rate,
          -drag * m.speed * section.radius * section.radius};
}

DraggedLoad along(const DraggedLoad& a, double x, const DraggedLoad& b) {
  return {a.tension + x * b.tension, a.torque + x * b.torque};
}

/// Integrates from `lo` + `length` up to `lo` within one section and between two stations.
DraggedLoad climb(const DraggedString& d, const DraggedMotion& m, const DraggedSection& section,
                  double lo, double length, double step, DraggedLoad load) {
  const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
  const double h = length / count, inside = 1e-6 * h;
  for (int i = count; i > 0; --i) {
    const double s = lo + h * i;
    const auto at_depth = [&](double depth, const DraggedLoad& x) {
      return slope(d, m, section, depth, depth >= lo + length ? inside : -inside, x);
    };
    const DraggedLoad k1 = at_depth(s, load), k2 = at_depth(s - 0.5 * h, along(load, -0.5 * h, k1));
    const DraggedLoad k3 = at_depth(s - 0.5 * h, along(load, -0.5 * h, k2));
    const DraggedLoad k4 = at_depth(s - h, along(load, -h, k3));
    load = along(load, -h / 6.0, k1);
    load = along(load, -h / 3.0, k2);
    load = along(load, -h / 3.0, k3);
    load = along(load, -h / 6.0, k4);
  }
  return load;
}

}  // namespace

DraggedLoad dragged_load(const DraggedString& d, const DraggedMotion& m, double depth,
                         double step) {
  double total = 0.0;
  for (const DraggedSection& s : d.sections) total += s.length;
  DraggedLoad load{m.pull, m.torque};
  double end = total;
  for (auto section = d.sections.rbegin(); section != d.sections.rend(); ++section) {
    const double start = end - section->length;
    std::vector<double> cuts{end, std::max(start, depth)};
    for (const DraggedStation& s : d.stations)
      if (s.depth > cuts[1] && s.depth < end) cuts.push_back(s.depth);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = cuts.size() - 1; k > 0 && cuts[k - 1] < cuts[k]; --k)
      load = climb(d, m, *section, cuts[k - 1], cuts[k] - cuts[k - 1], step, load);
    end = start;
    if (end <= depth) break;
  }
  return load;
}

}  // namespace tdbd::reference

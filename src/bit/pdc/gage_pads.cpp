#include "bit/pdc/gage_pads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/text.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

constexpr int chords = 8;                 ///< number of chords of the outer side
constexpr double steel_density = 7850.0;  ///< kg/m3

const Cutter& highest(const std::vector<Cutter>& cutters) {
  return *std::ranges::max_element(cutters, {}, &Cutter::tip_height);
}

/// Outline of a pad normal to the axis, counter-clockwise seen against +z: the arc, then the flat
/// back.
std::vector<Vec3> outline(double radius, double width, double thickness) {
  const double half_angle = 0.5 * width / radius;
  std::vector<Vec3> points;
  for (int k = 0; k <= chords; ++k) {
    const double angle = half_angle * (2.0 * k / chords - 1.0);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  const double half_width = radius * std::sin(half_angle);
  points.emplace_back(radius - thickness, half_width, 0.0);
  points.emplace_back(radius - thickness, -half_width, 0.0);
  return points;
}

/// Prism over a convex outline (counter-clockwise seen against +z), from z = top to bottom > top.
mesh::TriangleMesh prism(const std::vector<Vec3>& points, double top, double bottom) {
  mesh::TriangleMesh m;
  const int n = static_cast<int>(points.size());
  for (const Vec3& p : points) m.positions.emplace_back(p.x(), p.y(), bottom);
  for (const Vec3& p : points) m.positions.emplace_back(p.x(), p.y(), top);
  for (int k = 1; k + 1 < n; ++k) {
    m.triangles.push_back({0, k, k + 1});
    m.triangles.push_back({n, n + k + 1, n + k});
  }
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    m.triangles.push_back({n + k, n + next, next});
    m.triangles.push_back({n + k, next, k});
  }
  return m;
}

}  // namespace

std::vector<PadProblem> pad_problems(const GagePads& pads, double gage_radius) {
  if (pads.count == 0) return {};
  const double radius = gage_radius - pads.under_gage;
  if (!(radius > 0.0))
    return {{"under_gage", mm_text(pads.under_gage),
             "less than the gage radius, " + mm_text(gage_radius)}};
  std::vector<PadProblem> problems;
  const double widest = std::min(full_turn / pads.count, 0.5 * full_turn) * radius;
  if (!(pads.width < widest))
    problems.push_back(
        {"width", mm_text(pads.width),
         fmt::format("less than {}, for {} pads beside one another", mm_text(widest), pads.count)});
  const double rise = radius * (1.0 - std::cos(0.5 * std::min(pads.width, widest) / radius));
  if (!(pads.thickness > rise && pads.thickness < radius))
    problems.push_back({"thickness", mm_text(pads.thickness),
                        fmt::format("more than the rise of its arc, {}, and less than its outer "
                                    "radius, {}",
                                    mm_text(rise), mm_text(radius))});
  return problems;
}

std::vector<Part> gage_pads(const GagePads& pads, const std::vector<Cutter>& cutters,
                            double gage_radius) {
  std::vector<Part> parts;
  if (pads.count == 0) return parts;
  const Cutter& top = highest(cutters);
  const double start = pads.height.value_or(top.tip_height + 0.5 * top.diameter);
  const auto sides = outline(gage_radius - pads.under_gage, pads.width, pads.thickness);
  for (int k = 0; k < pads.count; ++k) {
    Part& pad = parts.emplace_back();
    pad.name = fmt::format("gage-pad-{}", k + 1);
    pad.kind = PartKind::gage_pad;
    const double azimuth = top.azimuth - pads.behind / gage_radius + full_turn * k / pads.count;
    pad.X_BP.R = Eigen::AngleAxisd(azimuth, Vec3::UnitZ()).toRotationMatrix();
    pad.mesh_P = prism(sides, -start - pads.length, -start);
    pad.update_direction_B = Vec3::UnitX();
    pad.density = steel_density;
  }
  return parts;
}

}  // namespace tdbd::bit

#include "bit/pdc/pdc_bit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit/body/bit_body.hpp"
#include "bit/body/blade_body.hpp"
#include "core/error.hpp"
#include "core/types.hpp"

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

namespace {

void append(std::vector<Part>& parts, std::vector<Part> more) {
  for (Part& part : more) parts.push_back(std::move(part));
}

std::vector<Part> indexed_cutter_parts(const Cutter& c, int index, const PdcOptions& options) {
  std::vector<Part> parts = cutter_parts(c, options.meshing);
  for (Part& part : parts) {
    part.update_direction_B = update_direction(c.X_BC, options.directions, options.inside);
    part.group = index;
    part.cutter = index;
  }
  return parts;
}

void add_body(const PdcOptions& options, Bit& bit) {
  if (!options.blades) {
    bit.parts.push_back(
        bit_body(bit.cutters, options.body_setback, options.body_density, bit.gage_radius));
    return;
  }
  const BladeOptions& blades = *options.blades;
  std::string lines;
  for (const BladeProblem& p : blade_problems(bit.cutters, blades, bit.gage_radius))
    lines += fmt::format("{}{}: blades.{}: found {}, expected {}", lines.empty() ? "" : "\n",
                         bit.name, p.key, p.found, p.expected);
  if (!lines.empty()) throw InputError(lines);
  bit.parts.push_back(blade_body(bit.cutters, blades, bit.gage_radius));
  bit.blades = {blades.exposure, blades.slot_depth,
                junk_slot_area(blade_shape(bit.cutters, blades), blades, bit.gage_radius)};
}

}  // namespace

Bit pdc_bit(std::string name, std::vector<Cutter> cutters, const PdcOptions& options) {
  if (cutters.empty()) throw InputError(name + ": found no cutter, expected at least one");
  Bit bit;
  bit.name = std::move(name);
  bit.cutters = std::move(cutters);
  for (int i = 0; i < static_cast<int>(bit.cutters.size()); ++i) {
    bit.cutters[i].X_BC = cutter_pose(bit.cutters[i]);
    append(bit.parts, indexed_cutter_parts(bit.cutters[i], i, options));
  }
  bit.gage_radius = largest_radius(bit.parts);
  append(bit.parts, gage_pads(options.pads, bit.cutters, bit.gage_radius));
  add_body(options, bit);
  return bit;
}

}  // namespace tdbd::bit

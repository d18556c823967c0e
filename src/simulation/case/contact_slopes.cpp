#include "simulation/case/contact_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "simulation/case/part_bearing.hpp"

namespace tdbd::simulation {
namespace {

constexpr double depth = 1e-3;       // m
constexpr double usual_speed = 1.0;  // m/s

/// Area and edge of a circular segment of a disc, m2 and m.
struct Segment {
  double area, edge;
};

Segment segment_of(double diameter, double height) {
  const double a = 0.5 * diameter, half = std::acos(1.0 - std::min(height, a) / a);
  return {a * a * (half - std::sin(half) * std::cos(half)), 2.0 * a * half};
}

double normal_force(const ForcePlan& plan, const forces::PartCut& cut, std::optional<int> part) {
  const forces::Law& law = part ? law_of(plan, cut.kind, *part) : law_of(plan, cut.kind);
  return forces::force(law, cut).normal;
}

/// The first part that meets a condition; none: the law of its kind holds.
template <class Condition>
std::optional<int> first_part(const bit::Bit& bit, const Condition& condition) {
  const auto found = std::ranges::find_if(bit.parts, condition);
  if (found == bit.parts.end()) return std::nullopt;
  return static_cast<int>(found - bit.parts.begin());
}

std::optional<int> face_of(const bit::Bit& bit, int cutter) {
  return first_part(
      bit, [&](const bit::Part& p) { return p.cutter == cutter && p.kind == bit::PartKind::face; });
}

std::optional<int> tooth_of(const bit::Bit& bit, int cone, int row) {
  return first_part(bit, [&](const bit::Part& p) { return p.cone == cone && p.row == row; });
}

forces::PartCut cut_of(const bit::Cutter& c, const forces::Strength& strength) {
  const Segment s = segment_of(c.diameter, depth / std::cos(c.back_rake));
  forces::PartCut cut;
  cut.kind = bit::PartKind::face;
  cut.cut_area = s.area * std::cos(c.back_rake);
  cut.engaged_edge = s.edge;
  cut.depth = cut.cut_area / s.edge;
  cut.back_rake = c.back_rake;
  cut.diameter = c.diameter;
  cut.velocity = usual_speed * Vec3::UnitX();
  cut.normal = Vec3::UnitZ();
  cut.strength = strength;
  return cut;
}

forces::PartCut print_of(const bit::ToothRow& row, const forces::Strength& strength) {
  forces::PartCut cut;
  cut.kind = bit::PartKind::tooth;
  cut.contact_area = std::numbers::pi * (row.shape.diameter - depth) * depth;
  cut.depth = depth;
  cut.velocity = usual_speed * Vec3::UnitZ();
  cut.normal = Vec3::UnitZ();
  cut.strength = strength;
  return cut;
}

/// A formation has at least one layer.
const forces::Strength& strongest_of(const ForcePlan& plan) {
  return *std::ranges::max_element(plan.rock.strengths, {},
                                   [](const forces::Strength& s) { return s.confined; });
}

}  // namespace

dynamics::ContactSlopes contact_slopes(const bit::Bit& bit, const ForcePlan& plan) {
  const forces::Strength& strongest = strongest_of(plan);
  dynamics::ContactSlopes slopes;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const bit::Cutter& c = bit.cutters[i];
    const std::optional<int> face = face_of(bit, static_cast<int>(i));
    if (face && final_cutting(bit.parts[static_cast<std::size_t>(*face)]) != bit::Cutting::cuts)
      continue;
    const double slope = normal_force(plan, cut_of(c, strongest), face) / depth;
    const double down = std::cos(c.profile_angle), out = std::sin(c.profile_angle);
    slopes.axial_stiffness += slope * down * down;
    slopes.lateral_stiffness += 0.5 * slope * out * out;
  }
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j)
      slopes.axial_stiffness +=
          normal_force(plan, print_of(bit.cones[k].layout.rows[j], strongest),
                       tooth_of(bit, static_cast<int>(k), static_cast<int>(j))) /
          depth;
  const PartBearing others = bearing_of_parts(bit, plan, strongest);
  slopes.axial_stiffness += others.slope;
  slopes.lateral_stiffness += others.lateral_slope;
  return slopes;
}

double weight_borne(const bit::Bit& bit, const ForcePlan& plan, double depth_of_bit) {
  return bearing_of_parts(bit, plan, strongest_of(plan)).at_touch +
         contact_slopes(bit, plan).axial_stiffness * depth_of_bit;
}

}  // namespace tdbd::simulation

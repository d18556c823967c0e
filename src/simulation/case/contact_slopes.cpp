#include "simulation/case/contact_slopes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "bit/cone/swept_parts.hpp"
#include "mesh/measures.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {
namespace {

constexpr double full_depth = 1e-3;      // m
constexpr double depth_at_touch = 1e-5;  // m: flat parts of a mesh are flat to much less than this
constexpr double pressing_speed = 1.0;   // m/s

/// Mean of the part's vertices, in the bit frame.
Vec3 middle_B(const bit::Part& part) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x_P : part.mesh_P.positions) sum += x_P;
  return part.X_BP * (sum / static_cast<double>(part.mesh_P.positions.size()));
}

/// The parts in the sum: all of them, but only one tooth of each row of cones from mesh files.
std::vector<const bit::Part*> counted_parts(const bit::Bit& bit) {
  constexpr double apart = 1e-3;  // m, well below the distance between two rows
  std::vector<const bit::Part*> parts;
  for (const bit::Part& part : bit.parts)
    if (part.cone < 0 || part.kind != bit::PartKind::tooth) parts.push_back(&part);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (const int tooth : bit::one_tooth_of_each_row(bit, static_cast<int>(k), apart))
      parts.push_back(&bit.parts[static_cast<std::size_t>(tooth)]);
  return parts;
}

/// Area vector (m2) of the part of a triangle above a height.
Vec3 area_vector_above(const std::array<Vec3, 3>& x, const std::array<double, 3>& height) {
  std::array<Vec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] >= 0.0) kept[count++] = x[i];
    if ((height[i] >= 0.0) != (height[j] >= 0.0))
      kept[count++] = x[i] + height[i] / (height[i] - height[j]) * (x[j] - x[i]);
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < count; ++i) sum += mesh::area_vector(kept[0], kept[i - 1], kept[i]);
  return sum;
}

int index_of(const bit::Bit& bit, const bit::Part& part) {
  return static_cast<int>(&part - bit.parts.data());
}

/// If a cutter has no part for its face, the law of faces decides.
bool has_face_with_law(const ForcePlan& plan, const bit::Bit& bit, int cutter) {
  const auto face = std::ranges::find_if(bit.parts, [&](const bit::Part& p) {
    return p.cutter == cutter && p.kind == bit::PartKind::face;
  });
  if (face != bit.parts.end()) return has_law(plan, face->kind, index_of(bit, *face));
  return has_law(plan, bit::PartKind::face);
}

/// Whether a pad or a bit body has the law that it has by default: it is clear of the rock while
/// the bit drills, and touches it only after the cutters have sunk in.
bool bears_by_default(const ForcePlan& plan, const bit::Bit& bit, const bit::Part& part) {
  if (part.kind != bit::PartKind::gage_pad && part.kind != bit::PartKind::bit_body) return false;
  const auto* law = std::get_if<forces::Friction>(&law_of(plan, part.kind, index_of(bit, part)));
  const forces::Law own_law = own_law_of(part.kind);
  const auto& own = std::get<forces::Friction>(own_law);
  return law != nullptr && law->stress == own.stress && law->mu == own.mu && law->cap == own.cap &&
         law->full_angle == own.full_angle && law->slip_speed == own.slip_speed;
}

/// If faces have a law, they carry a cutter's weight.
bool presses(const ForcePlan& plan, const bit::Bit& bit, const bit::Part& part) {
  using bit::PartKind;
  const bool follows_a_face = part.cutter >= 0 && has_face_with_law(plan, bit, part.cutter);
  return final_cutting(part) != bit::Cutting::never && part.kind != PartKind::face &&
         !follows_a_face && part.row < 0 && has_law(plan, part.kind, index_of(bit, part)) &&
         !bears_by_default(plan, bit, part);
}

double normal_force(const forces::Law& law, const bit::Part& part, double area,
                    const forces::Strength& strength) {
  forces::PartCut cut;
  cut.kind = part.kind;
  cut.contact_area = area;
  cut.depth = full_depth;
  cut.velocity = pressing_speed * Vec3::UnitZ();
  cut.normal = Vec3::UnitZ();
  cut.strength = strength;
  return forces::force(law, cut).normal;
}

constexpr double depth = 1e-3;       // m
constexpr double usual_speed = 1.0;  // m/s

/// Area (m2) and edge (m) of a circular segment of a disc.
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

/// The law of the first part that meets a condition; if none does, the law of its kind.
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

Vec3 contact_direction_B(const bit::Bit& bit, const bit::Part& part) {
  const Vec3 middle = middle_B(part);
  if (part.cone < 0) {
    const double r = middle.head<2>().norm();
    const Vec3 out = r > 0.0 ? Vec3(middle.x() / r, middle.y() / r, 0.0) : Vec3(Vec3::UnitX());
    return part.update_direction_B.x() * out + part.update_direction_B.z() * Vec3::UnitZ();
  }
  const Pose& X_BK = bit.cones[static_cast<std::size_t>(part.cone)].X_BK;
  const Vec3 s = X_BK.R.col(2), arm = middle - X_BK.p, out = arm - arm.dot(s) * s;
  const double r = out.norm();
  if (!(r > 0.0)) return Vec3::UnitZ();
  return std::sqrt(std::max(0.0, 1.0 - s.z() * s.z())) / r * out + s.z() * s;
}

double area_at_depth(const bit::Part& part, const Vec3& direction_B, double depth) {
  const Vec3 u = part.X_BP.R.transpose() * direction_B;
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Vec3& x : part.mesh_P.positions) farthest = std::max(farthest, u.dot(x));
  double area = 0.0;  // the facets of a closed mesh beyond the plane and the section close
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    std::array<Vec3, 3> x;
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = part.mesh_P.positions[static_cast<std::size_t>(t[i])];
      height[i] = u.dot(x[i]) - (farthest - depth);
    }
    area += u.dot(area_vector_above(x, height));
  }
  return std::max(0.0, area);
}

PartBearing bearing_of_parts(const bit::Bit& bit, const ForcePlan& plan,
                             const forces::Strength& strength) {
  PartBearing sum;
  for (const bit::Part* counted : counted_parts(bit)) {
    const bit::Part& part = *counted;
    if (!presses(plan, bit, part)) continue;
    const forces::Law& law = law_of(plan, part.kind, index_of(bit, part));
    const Vec3 u = contact_direction_B(bit, part);
    const double down = part.cone < 0 ? u.z() : 1.0,
                 out = std::sqrt(std::max(0.0, 1.0 - down * down));
    const double first = normal_force(law, part, area_at_depth(part, u, depth_at_touch), strength);
    const double last = normal_force(law, part, area_at_depth(part, u, full_depth), strength);
    const double slope = std::max(0.0, last - first) / full_depth;
    sum.at_touch += std::max(0.0, down) * first;
    sum.slope += down * down * slope;
    sum.lateral_slope += 0.5 * out * out * slope;
  }
  return sum;
}

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

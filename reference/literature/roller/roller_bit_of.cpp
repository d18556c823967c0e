#include "reference/literature/roller/roller_bit_of.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// Integral of density (x2 + y2) over the solid in the mesh, in K, kg m2: tetrahedra from K's
/// origin.
double inertia_about_the_journal(const bit::Part& part, const Pose& X_KP) {
  double sum = 0.0;
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    const Vec3 a = X_KP * part.mesh_P.positions[at(t[0])];
    const Vec3 b = X_KP * part.mesh_P.positions[at(t[1])];
    const Vec3 c = X_KP * part.mesh_P.positions[at(t[2])];
    const auto squares = [&](int i) {
      return a[i] * a[i] + b[i] * b[i] + c[i] * c[i] + a[i] * b[i] + a[i] * c[i] + b[i] * c[i];
    };
    sum += a.dot(b.cross(c)) / 60.0 * (squares(0) + squares(1));
  }
  return part.density * sum;
}

double ball_radius(const bit::ToothShape& shape) {
  switch (shape.kind) {
    case bit::ToothKind::hemispherical:
      return shape.diameter / 2.0;
    case bit::ToothKind::conical:
      return shape.tip_radius;
    case bit::ToothKind::chisel:
    case bit::ToothKind::milled_chisel:
      break;
  }
  return shape.crest_width / 2.0;
}

/// Adds a tooth to its row, at the height of its mesh on its axis.
void add_tooth(RollerRow& row, const bit::Part& tooth, const Pose& X_KP, double apex) {
  double height = 0.0;
  for (const Vec3& x_P : tooth.mesh_P.positions) height = std::max(height, x_P.z());
  const Vec3 tip_K = X_KP * Vec3(0.0, 0.0, height);
  row.along = -(apex + tip_K.z());
  row.radius = std::hypot(tip_K.x(), tip_K.y());
  row.angles.push_back(std::atan2(tip_K.y(), tip_K.x()));
}

void need_a_plain_journal(const bit::Cone& cone, const std::string& model) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  if (cone.layout.rows.empty())
    throw InputError(model + ": found " + cone.name +
                     " without rows of teeth, expected a cone that is drawn, not read from meshes");
  if (cone.layout.skew != 0.0)
    throw InputError(model + ": found a skew of " + std::to_string(cone.layout.skew * degrees) +
                     " deg of " + cone.name +
                     ", expected 0: the journal's axis stands in a plane along the bit's axis");
}

void need_cones_alone(const bit::Bit& bit, const std::string& model) {
  if (!bit.cutters.empty())
    throw InputError(model + ": found a bit with " + std::to_string(bit.cutters.size()) +
                     " cutters, expected roller cones alone");
  if (bit.cones.empty())
    throw InputError(model + ": found a bit without cones, expected a roller cone bit");
  for (const bit::Cone& cone : bit.cones) need_a_plain_journal(cone, model);
}

RollerCone cone_of(const bit::Bit& bit, std::size_t index) {
  const bit::ConeLayout& layout = bit.cones[index].layout;
  RollerCone cone{
      layout.azimuth, layout.journal_angle, layout.offset, -layout.foot_height, 0.0, {}};
  for (const bit::ToothRow& row : layout.rows)
    cone.rows.push_back({0.0, 0.0, ball_radius(row.shape), {}});
  const Pose X_KB = inverse(bit.cones[index].X_BK);
  for (const bit::Part& part : bit.parts) {
    if (part.cone != static_cast<int>(index)) continue;
    const Pose X_KP = X_KB * part.X_BP;
    cone.inertia += inertia_about_the_journal(part, X_KP);
    if (part.kind == bit::PartKind::tooth && part.row >= 0)
      add_tooth(cone.rows[at(part.row)], part, X_KP, layout.apex);
  }
  return cone;
}

}  // namespace

RollerBit roller_bit_of(const bit::Bit& bit, const std::string& model) {
  need_cones_alone(bit, model);
  RollerBit roller;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) roller.cones.push_back(cone_of(bit, k));
  return roller;
}

}  // namespace tdbd::reference

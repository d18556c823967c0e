#include "reference/literature/roller/roller_bit_of.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// Integral of density (x2 + y2) over the solid in the mesh, in K, kg m2, as a sum over tetrahedra
/// from K's origin.
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

/// Distance, m, from the layout's foot inwards to the point where the common perpendicular of a
/// skewed journal and the bit's axis meets the journal. The line of a skewed journal is that of a
/// journal without skew at another azimuth. The layout's foot is outside the plane of the latter by
/// offset * sin(skew).
double inwards_of_the_foot(const bit::ConeLayout& layout) {
  return layout.offset * std::sin(layout.skew) / std::cos(layout.journal_angle);
}

/// Adds a tooth to its row, at the height of its mesh on its axis. `origin`: position, m, of the
/// cone's frame along the journal, inwards from the foot of the common perpendicular.
void add_tooth(RollerRow& row, const bit::Part& tooth, const Pose& X_KP, double origin) {
  double height = 0.0;
  for (const Vec3& x_P : tooth.mesh_P.positions) height = std::max(height, x_P.z());
  const Vec3 tip_K = X_KP * Vec3(0.0, 0.0, height);
  row.along = -(origin + tip_K.z());
  row.radius = std::hypot(tip_K.x(), tip_K.y());
  row.angles.push_back(std::atan2(tip_K.y(), tip_K.x()));
}

void need_rows(const bit::Cone& cone, const std::string& model) {
  if (cone.layout.rows.empty())
    throw InputError(model + ": found " + cone.name +
                     " without rows of teeth, expected a cone that is drawn, not read from meshes");
}

/// Throws for a skewed journal along the bit's axis, which has no azimuth to rotate.
void need_an_azimuth(const bit::Cone& cone, const std::string& model) {
  constexpr double least_cosine = 1e-6;
  if (cone.layout.skew != 0.0 && std::cos(cone.layout.journal_angle) < least_cosine)
    throw InputError(model + ": found a skewed journal along the bit's axis of " + cone.name +
                     ", expected a skew of 0 or a journal angle below 90 deg");
}

void need_cones_alone(const bit::Bit& bit, const std::string& model) {
  if (!bit.cutters.empty())
    throw InputError(model + ": found a bit with " + std::to_string(bit.cutters.size()) +
                     " cutters, expected roller cones alone");
  if (bit.cones.empty())
    throw InputError(model + ": found a bit without cones, expected a roller cone bit");
  for (const bit::Cone& cone : bit.cones) {
    need_rows(cone, model);
    need_an_azimuth(cone, model);
  }
}

RollerCone cone_of(const bit::Bit& bit, std::size_t index) {
  const bit::ConeLayout& layout = bit.cones[index].layout;
  const double inwards = inwards_of_the_foot(layout);
  RollerCone cone{layout.azimuth + layout.skew,
                  layout.journal_angle,
                  layout.offset * std::cos(layout.skew),
                  inwards * std::sin(layout.journal_angle) - layout.foot_height,
                  0.0,
                  {}};
  for (const bit::ToothRow& row : layout.rows)
    cone.rows.push_back({0.0, 0.0, ball_radius(row.shape), {}});
  const Pose X_KB = inverse(bit.cones[index].X_BK);
  for (const bit::Part& part : bit.parts) {
    if (part.cone != static_cast<int>(index)) continue;
    const Pose X_KP = X_KB * part.X_BP;
    cone.inertia += inertia_about_the_journal(part, X_KP);
    if (part.kind == bit::PartKind::tooth && part.row >= 0)
      add_tooth(cone.rows[at(part.row)], part, X_KP, layout.apex - inwards);
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

#include "bit/cone/cone_measures.hpp"

#include <cmath>

#include "bit/cone/cone_parts.hpp"
#include "bit/cone/cone_reach.hpp"

namespace tdbd::bit {

ConeMass cone_mass(const Bit& bit, int cone) {
  const Pose X_KB = inverse(bit.cones[static_cast<std::size_t>(cone)].X_BK);
  ConeMass c;
  for (const Part& part : bit.parts)
    if (part.cone == cone && part.density > 0.0)
      c.body_K = combined(
          c.body_K, transformed(mass_properties(part.mesh_P, part.density), X_KB * part.X_BP));
  const Mat3& i = c.body_K.inertia;
  c.centre_off_axis = c.body_K.centre.head<2>().norm();
  c.axial_inertia = i(2, 2) + c.body_K.mass * c.centre_off_axis * c.centre_off_axis;
  const double difference = std::hypot(i(0, 0) - i(1, 1), 2.0 * i(0, 1));
  c.asymmetry = c.axial_inertia > 0.0 ? difference / c.axial_inertia : 0.0;
  return c;
}

Vec3 deepest_B(const Cone& cone, double radius, double z_K) {
  const Vec3 z_B = cone.X_BK.R.col(2);
  const Vec3 down_B = (Vec3::UnitZ() - z_B.z() * z_B).normalized();
  return cone.X_BK * Vec3(0.0, 0.0, z_K) + radius * down_B;
}

RowMeasures row_measures(const Cone& cone, const ToothRow& row) {
  constexpr double on_axis = 1e-9;  // m
  const Vec3 tip_K = tooth_pose(cone.layout, row, 0.0) * Vec3(0.0, 0.0, row.shape.protrusion);
  const double radius = tip_K.x();
  const Vec3 lowest_B = deepest_B(cone, radius, tip_K.z());
  const double bit_radius = lowest_B.head<2>().norm();
  return {radius, bit_radius, -lowest_B.z(),
          reach_of(cone.X_BK, row_meridian(cone.layout, row)).radius,
          radius > on_axis ? bit_radius / radius : 0.0};
}

}  // namespace tdbd::bit

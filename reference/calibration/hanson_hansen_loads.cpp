#include "reference/calibration/hanson_hansen_loads.hpp"

#include <cmath>

namespace tdbd::reference {
namespace {

constexpr double slip_speed = 1e-3;  // m/s

/// Weight and torque of a force of 1 N against e1 or e2.
Eigen::Vector2d of_unit_force(const forces::PartCut& cut, const Vec3& against) {
  const Vec3 force = -against;
  return {-force.z(), -cut.point.cross(force).z()};
}

void add(const forces::PartCut& cut, const Coefficients& c, UnitLoads& unit) {
  const double speed = cut.velocity.norm();
  const Vec3 e1 = cut.velocity / speed;
  const Vec3 e2 = (cut.normal - cut.normal.dot(e1) * e1).normalized();
  const double fade = speed / std::sqrt(speed * speed + slip_speed * slip_speed);
  const double Scc = cut.strength.unconfined +
                     c.pressure_share * (cut.strength.confined - cut.strength.unconfined);
  const Eigen::Vector2d along = fade * Scc * of_unit_force(cut, e1);
  const Eigen::Vector2d pressing = fade * Scc * of_unit_force(cut, e2);
  if (cut.kind == bit::PartKind::chamfer) {
    unit.col(3) += cut.contact_area * pressing;
    unit.col(4) += cut.contact_area * along;
    return;
  }
  const Eigen::Vector2d both = along + std::tan(cut.back_rake + c.A3) * pressing;
  unit.col(0) += cut.cut_area * both;
  unit.col(1) += cut.cut_area * std::tan(cut.back_rake) * both;
  unit.col(2) += c.te * cut.engaged_edge * both;
}

}  // namespace

Factors factors_of(const Coefficients& c) {
  return Factors{c.A1, c.A1 * c.A2, c.A4, c.A5, c.A5 * c.A6};
}

Coefficients with_factors(Coefficients c, const Factors& x) {
  c.A1 = x[0];
  c.A2 = x[0] > 0.0 ? x[1] / x[0] : 0.0;
  c.A4 = x[2];
  c.A5 = x[3];
  c.A6 = x[3] > 0.0 ? x[4] / x[3] : 0.0;
  return c;
}

UnitLoads unit_loads(const std::vector<forces::PartCut>& cuts, const Coefficients& c) {
  UnitLoads unit = UnitLoads::Zero();
  for (const forces::PartCut& cut : cuts)
    if (cut.kind == bit::PartKind::face || cut.kind == bit::PartKind::chamfer) add(cut, c, unit);
  return unit;
}

Eigen::Vector2d loads(const std::vector<forces::PartCut>& cuts, const Coefficients& c) {
  return unit_loads(cuts, c) * factors_of(c);
}

Eigen::Vector2d mean_over_steps(const std::vector<std::vector<forces::PartCut>>& steps,
                                const Coefficients& c) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const std::vector<forces::PartCut>& cuts : steps) sum += loads(cuts, c);
  return sum / static_cast<double>(steps.size());
}

Eigen::Vector2d depth_slopes(const std::vector<forces::PartCut>& cuts, const Coefficients& c) {
  const UnitLoads unit = unit_loads(cuts, c);
  const Factors x = factors_of(c);
  const Eigen::Vector2d of_areas = x[0] * unit.col(0) + x[1] * unit.col(1);
  return of_areas.cwiseQuotient(unit * x);
}

}  // namespace tdbd::reference

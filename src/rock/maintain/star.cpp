#include "rock/maintain/star.hpp"

namespace tdbd::rock {
namespace {

/// Whether a triangle at a corner of t is turned by more than 90 degrees against t.
bool is_turned_against_neighbour(const mesh::Surface& s, int t, const Vec3& area) {
  bool found = false;
  for (const int v : s.triangles[at(t)])
    if (!found)
      mesh::visit_corners(
          s, v, [&](int c) { found = found || area.dot(doubled_area(facet_at(s, c))) < 0.0; });
  return found;
}

}  // namespace

double worst_quality(const mesh::Surface& s, int v) {
  double worst = 1.0;
  mesh::visit_corners(s, v, [&](int c) { worst = std::min(worst, quality(facet_at(s, c))); });
  return worst;
}

std::optional<Refusal> judge_turn(const Vec3& before, const Vec3& after,
                                  const MaintenanceLimits& limits) {
  if (after.dot(before) < limits.least_normal_cosine * after.norm() * before.norm())
    return Refusal::normal;
  const double lean = limits.steepest_overhang * after.norm();  // z is down
  if (after.z() > lean && before.z() <= limits.steepest_overhang * before.norm())
    return Refusal::overhang;
  if (after.z() >= 0.0 && before.z() < -limits.steepest_overhang * before.norm())
    return Refusal::overhang;
  return std::nullopt;
}

bool is_sharp(const mesh::Surface& s, int c, const MaintenanceLimits& limits) {
  const int o = s.opposite_of(c);
  if (o < 0) return false;
  const Vec3 m = area_vector(facet_at(s, c)), n = area_vector(facet_at(s, o));
  return m.dot(n) < limits.sharp_cosine * m.norm() * n.norm();
}

bool is_on_ridge(const mesh::Surface& s, int v, const MaintenanceLimits& limits) {
  bool found = false;
  mesh::visit_corners(s, v,
                      [&](int c) { found = found || is_sharp(s, mesh::next_corner(c), limits); });
  return found;
}

bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t) {
  const Vec3 area = doubled_area(facet_at(s, 3 * t));
  return area.z() > -limits.steepest_overhang * area.norm() &&
         is_turned_against_neighbour(s, t, area);
}

}  // namespace tdbd::rock

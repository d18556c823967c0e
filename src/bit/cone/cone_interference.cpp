#include "bit/cone/cone_interference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_parts.hpp"
#include "bit/cone/meridian_gap.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

double within_turn(double angle) {
  const double turned = std::fmod(angle, full_turn);
  return turned < 0.0 ? turned + full_turn : turned;
}

Clearance described(const Gap& gap, const Cone& a, const Turning& of_a, const Cone& b,
                    const Turning& of_b) {
  const Vec3 place_B = a.X_BK * Vec3(gap.point_a.r * std::cos(gap.angle_a),
                                     gap.point_a.r * std::sin(gap.angle_a), -gap.point_a.s);
  const Vec3 place_K = inverse(b.X_BK) * place_B;
  return {of_a.part,
          of_b.part,
          gap.distance,
          within_turn(gap.angle_a - of_a.first_angle),
          within_turn(std::atan2(place_K.y(), place_K.x()) - of_b.first_angle),
          place_B,
          gap.is_exact};
}

void add_pair(const Cone& a, const Cone& b, std::vector<Clearance>& all) {
  const std::vector<Turning> parts_a = turning_parts(a), parts_b = turning_parts(b);
  std::vector<Clearance> clashes;
  Clearance nearest;
  nearest.distance = INFINITY;
  for (const Turning& of_a : parts_a)
    for (const Turning& of_b : parts_b) {
      const Gap gap = smallest_gap(of_a.meridian, a.X_BK, of_b.meridian, b.X_BK,
                                   clearance_tolerance, std::max(0.0, nearest.distance));
      const Clearance here = described(gap, a, of_a, b, of_b);
      if (is_clash(here)) clashes.push_back(here);
      if (here.distance < nearest.distance) nearest = here;
    }
  if (clashes.empty()) clashes.push_back(nearest);
  all.insert(all.end(), clashes.begin(), clashes.end());
}

}  // namespace

std::vector<Turning> turning_parts(const Cone& cone) {
  std::vector<Turning> parts{{cone.name + "/body", 0.0, shell_meridian(cone.layout.shell)}};
  for (std::size_t j = 0; j < cone.layout.rows.size(); ++j) {
    const ToothRow& row = cone.layout.rows[j];
    parts.push_back({fmt::format("{}/row-{}/tooth-1", cone.name, j + 1), row.angles.front(),
                     row_meridian(cone.layout, row)});
  }
  return parts;
}

std::vector<Clearance> cone_clearances(const std::vector<Cone>& cones) {
  std::vector<Clearance> all;
  for (std::size_t i = 0; i < cones.size(); ++i)
    for (std::size_t k = i + 1; k < cones.size(); ++k)
      if (!cones[i].layout.shell.empty() && !cones[k].layout.shell.empty())
        add_pair(cones[i], cones[k], all);
  std::ranges::stable_sort(all, {}, &Clearance::distance);
  return all;
}

std::string clearance_text(const Clearance& c) {
  if (!c.is_exact && c.distance > -clearance_tolerance)
    return fmt::format(
        "{} and {} about {:.3f} mm apart all over, near ({:.1f}, {:.1f}, {:.1f}) mm and elsewhere "
        "(given up after {} patches; two cones in one place?)",
        c.part_a, c.part_b, 1e3 * std::abs(c.distance), 1e3 * c.place_B.x(), 1e3 * c.place_B.y(),
        1e3 * c.place_B.z(), most_patches);
  return fmt::format(
      "{} of {:.3f} mm of {} (at {:.1f} deg) and {} (at {:.1f} deg) at ({:.1f}, {:.1f}, {:.1f}) mm",
      c.distance < 0.0 ? "an overlap" : "a gap", 1e3 * std::abs(c.distance), c.part_a,
      c.angle_a / degree, c.part_b, c.angle_b / degree, 1e3 * c.place_B.x(), 1e3 * c.place_B.y(),
      1e3 * c.place_B.z());
}

}  // namespace tdbd::bit

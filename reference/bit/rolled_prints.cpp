#include "reference/bit/rolled_prints.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

Mat3 about_z(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(); }

/// A tip in space after the bit has turned by `turned`. The cone rolls in the negative sense about
/// its Z.
Vec3 tip_W(const RolledRow& row, const Vec3& tip_K, double turned) {
  return about_z(turned) * (row.X_BK * (about_z(-row.speed * turned) * tip_K));
}

double lowest_between(const RolledRow& row, const Vec3& tip_K, double lo, double hi) {
  for (int i = 0; i < 80; ++i) {
    const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
    (tip_W(row, tip_K, a).z() < tip_W(row, tip_K, b).z() ? lo : hi) =
        tip_W(row, tip_K, a).z() < tip_W(row, tip_K, b).z() ? a : b;
  }
  return 0.5 * (lo + hi);
}

/// Largest difference in azimuth at which places with the radii of these two are within `near`, by
/// the law of cosines.
double farthest_azimuth(const Vec3& a, const Vec3& b, double near) {
  const double cosine =
      (a.squaredNorm() + b.squaredNorm() - near * near) / (2.0 * a.norm() * b.norm());
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

std::vector<RolledPrint> rolled_prints(const RolledRow& row, double from, double to) {
  const double step = full_turn / (300.0 * row.speed);
  std::vector<RolledPrint> prints;
  for (const Vec3& tip_K : row.tips_K)
    for (double t = from - 2 * step; t < to + 2 * step; t += step) {
      const double before = tip_W(row, tip_K, t - step).z(), at = tip_W(row, tip_K, t).z(),
                   after = tip_W(row, tip_K, t + step).z();
      if (at <= before || at < after) continue;  // z points down
      const double turned = lowest_between(row, tip_K, t - step, t + step);
      if (turned < from || turned >= to) continue;
      const Vec3 place = tip_W(row, tip_K, turned);
      prints.push_back({turned, {place.x(), place.y(), 0.0}});
    }
  return prints;
}

double share_near_earlier(const std::vector<RolledRow>& rows, std::size_t own, int revolutions) {
  std::vector<RolledPrint> all;
  for (const RolledRow& row : rows)
    for (const RolledPrint& p : rolled_prints(row, -1.5 * full_turn, full_turn * revolutions))
      all.push_back(p);
  constexpr double itself = 1e-5;  // rad: lowest places are found to 1e-7
  long judged = 0, hits = 0;
  const double near = rows[own].near;
  for (const RolledPrint& p : rolled_prints(rows[own], 0.0, full_turn * revolutions)) {
    ++judged;
    hits += std::ranges::any_of(all, [&](const RolledPrint& q) {
      const double age = p.turned - q.turned;
      return age > itself && age <= full_turn + farthest_azimuth(p.place, q.place, near) &&
             (p.place - q.place).norm() < near;
    });
  }
  return static_cast<double>(hits) / static_cast<double>(judged);
}

double mean_tips_in_contact(const RolledRow& row, double penetration) {
  constexpr int samples = 20000;
  double lowest = -1e300;
  for (int i = 0; i < samples; ++i)
    lowest = std::max(lowest, (row.X_BK * (about_z(full_turn * i / samples) * row.tips_K[0])).z());
  long in_contact = 0;
  for (int i = 0; i < samples; ++i)
    for (const Vec3& tip_K : row.tips_K)
      in_contact +=
          (row.X_BK * (about_z(full_turn * i / samples) * tip_K)).z() >= lowest - penetration;
  return static_cast<double>(in_contact) / samples;
}

}  // namespace tdbd::reference

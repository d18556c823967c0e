#include "forces/rock/formation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace tdbd::forces {

Vec3 bedding_normal(double dip, double azimuth) {
  return {-std::sin(dip) * std::cos(azimuth), -std::sin(dip) * std::sin(azimuth), std::cos(dip)};
}

std::size_t layer_at(const Formation& formation, const Vec3& x_W) {
  const double depth = formation.normal_W.dot(x_W);
  const auto deeper = std::upper_bound(formation.tops.begin(), formation.tops.end(), depth);
  return static_cast<std::size_t>(deeper - formation.tops.begin());
}

const Strength& strength_at(const Formation& formation, const Vec3& x_W) {
  return formation.strengths[layer_at(formation, x_W)];
}

std::string formation_problem(const Formation& f) {
  if (f.strengths.size() != f.tops.size() + 1)
    return fmt::format("{} rocks between {} planes, expected one rock more than planes",
                       f.strengths.size(), f.tops.size());
  if (std::abs(f.normal_W.norm() - 1.0) > tolerance::rotation)
    return fmt::format("a normal of length {}, expected 1", f.normal_W.norm());
  for (std::size_t k = 1; k < f.tops.size(); ++k)
    if (!(f.tops[k] > f.tops[k - 1]))
      return fmt::format("a plane at {} m after one at {} m, expected rising depths", f.tops[k],
                         f.tops[k - 1]);
  for (const Strength& s : f.strengths)
    if (!(s.unconfined > 0.0) || !(s.confined > 0.0))
      return fmt::format("a strength of {} Pa, confined {} Pa, expected > 0", s.unconfined,
                         s.confined);
  return {};
}

}  // namespace tdbd::forces

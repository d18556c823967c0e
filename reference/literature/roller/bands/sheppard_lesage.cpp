#include "reference/literature/roller/bands/sheppard_lesage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"

namespace tdbd::reference {
namespace {

constexpr double revolution = 2.0 * std::numbers::pi;

double lowest_radius(const RollerCone& cone, const RollerRow& row) {
  return row.along * std::cos(cone.journal_angle) + row.radius * std::sin(cone.journal_angle);
}

void need_positive(double value, const char* what) {
  if (!(std::isfinite(value) && value > 0.0))
    throw InputError(fmt::format(
        "Sheppard and Lesage: found {} for the {}, expected a positive number", value, what));
}

void need_rows(const RollerBit& bit) {
  if (bit.cones.empty())
    throw InputError("Sheppard and Lesage: found a bit without cones, expected at least one");
  for (const RollerCone& cone : bit.cones)
    if (cone.rows.empty())
      throw InputError("Sheppard and Lesage: found a cone without rows, expected at least one");
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows)
      if (!(row.radius > 0.0))
        throw InputError("Sheppard and Lesage: found a row on its journal, expected one around it");
}

Vec3 turned_to(double azimuth, const Vec3& v) {
  return {std::cos(azimuth) * v.x() - std::sin(azimuth) * v.y(),
          std::sin(azimuth) * v.x() + std::cos(azimuth) * v.y(), v.z()};
}

/// Buffers shared by the cones of a solution.
struct BandWork {
  std::vector<BandStrip> strips;
};

BandCone free_cone_in(BandWork& work, const RollerCone& cone, const BandRock& rock,
                      const BandMotion& motion, const BandOptions& options, int& evaluations) {
  lay_strips(cone, motion, options, work.strips);
  const auto moment = [&](double speed) { return band_loads(work.strips, rock, speed).moment; };
  const BracketedRoot root =
      bracketed_root(moment, {.low = -options.greatest_ratio * motion.bit_speed,
                              .high = -options.least_ratio * motion.bit_speed,
                              .what = "Sheppard and Lesage: the speed of a free cone (rad/s)"});
  evaluations += root.evaluations;
  BandCone free;
  free.ratio = -root.x / motion.bit_speed;
  free.loads = band_loads(work.strips, rock, root.x);
  for (std::size_t r = 0; r < cone.rows.size(); ++r)
    free.rows.push_back(row_loads(work.strips, rock, root.x, r));
  const double h = 1e-4 * std::abs(root.x);
  free.lag = cone.inertia * 2.0 * h / (moment(root.x - h) - moment(root.x + h));
  return free;
}

void add_cone(const RollerCone& cone, BandCone free, SheppardLesage& sum) {
  sum.weight -= free.loads.force.z();
  sum.torque -= free.loads.torque;
  sum.volume_rate += free.loads.volume_rate;
  const Vec3 force_B = turned_to(cone.azimuth, free.loads.force);
  sum.lateral += Vec3(force_B.x(), force_B.y(), 0.0);
  sum.cones.push_back(std::move(free));
}

}  // namespace

BandCone free_cone(const RollerCone& cone, const BandRock& rock, const BandMotion& motion,
                   const BandOptions& options, int& evaluations) {
  BandWork work;
  return free_cone_in(work, cone, rock, motion, options, evaluations);
}

SheppardLesage sheppard_lesage(const RollerBit& bit, const BandRock& rock, double bit_speed,
                               double advance, const BandOptions& options) {
  need_rows(bit);
  need_positive(rock.specific_energy, "specific energy");
  need_positive(bit_speed, "rotary speed");
  need_positive(advance, "advance");
  SheppardLesage sum;
  sum.advance = advance;
  sum.rate = advance * bit_speed / revolution;
  BandWork work;
  for (const RollerCone& cone : bit.cones)
    add_cone(cone,
             free_cone_in(work, cone, rock, {bit_speed, sum.rate, bit.cones.size()}, options,
                          sum.evaluations),
             sum);
  return sum;
}

SheppardLesage sheppard_lesage_under(const RollerBit& bit, const BandRock& rock, double bit_speed,
                                     double weight, const BandOptions& options,
                                     double most_advance) {
  need_positive(weight, "weight on bit");
  int evaluations = 0;
  const auto excess = [&](double advance) {
    const SheppardLesage s = sheppard_lesage(bit, rock, bit_speed, advance, options);
    evaluations += s.evaluations;
    return s.weight - weight;
  };
  constexpr double least = 1e-9;  // m per revolution
  double high = 1e-4;
  while (high < most_advance && excess(high) < 0.0) high = std::min(2.0 * high, most_advance);
  const BracketedRoot root =
      bracketed_root(excess, {.low = least,
                              .high = high,
                              .relative = 1e-13,
                              .what = "Sheppard and Lesage: the advance under the weight (m)"});
  SheppardLesage found = sheppard_lesage(bit, rock, bit_speed, root.x, options);
  found.evaluations += evaluations;
  return found;
}

double ratio_under_constant_friction(const RollerCone& cone, const std::vector<double>& weights) {
  std::vector<std::pair<double, double>> rows;  // ratio of the row, and its pull on the cone
  double all = 0.0;
  for (std::size_t r = 0; r < cone.rows.size(); ++r) {
    const RollerRow& row = cone.rows[r];
    rows.emplace_back(lowest_radius(cone, row) / row.radius, weights.at(r) * row.radius);
    all += rows.back().second;
  }
  std::ranges::sort(rows);
  double below = 0.0;
  for (const auto& [ratio, pull] : rows)
    if ((below += pull) >= 0.5 * all) return ratio;
  throw InputError("Sheppard and Lesage: found a cone without rows, expected at least one");
}

double ratio_under_viscous_slip(const RollerCone& cone, const std::vector<double>& weights) {
  double pull = 0.0, drag = 0.0;
  for (std::size_t r = 0; r < cone.rows.size(); ++r) {
    const RollerRow& row = cone.rows[r];
    pull += weights.at(r) * row.radius * lowest_radius(cone, row);
    drag += weights.at(r) * row.radius * row.radius;
  }
  return pull / drag;
}

double small_arc(const RollerCone& cone, const RollerRow& row, double advance) {
  return std::sqrt(2.0 * lowest_radius(cone, row) * advance / (3.0 * row.along * row.radius));
}

}  // namespace tdbd::reference

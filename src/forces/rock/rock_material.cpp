#include "forces/rock/rock_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/tolerance.hpp"

namespace tdbd::forces {
namespace {

constexpr double psi = 6894.757293168361;  // Pa

constexpr Quoted seen(double value) { return {value, Evidence::seen}; }
constexpr Quoted derived(double value) { return {value, Evidence::derived}; }
constexpr Quoted recall(double value) { return {value, Evidence::recall}; }
constexpr Quoted assumed(double value) { return {value, Evidence::assumed}; }

constexpr std::string_view single_cutters =
    "strength: single-cutter rows of Sandia, github Atashnezhad/PhD_Dissertation";

constexpr std::array<KnownRock, 9> rock_table{{
    {"berea-sandstone", seen(7100 * psi), recall(35 * degree), single_cutters},
    {"sierra-white-granite", seen(21500 * psi), assumed(45 * degree), single_cutters},
    {"mancos-shale", seen(65 * MPa), seen(23.8 * degree),
     "Zijsling 1987 (SPE 16529) as in Miedema, Delft Sand, Clay and Rock Cutting, 9.5"},
    {"texas-granite", seen(19400 * psi), assumed(45 * degree), single_cutters},
    {"forge-granitoid", derived(186.4 * MPa), seen(38.66 * degree),
     "cohesion 44.8 MPa and angle of a FORGE verification script (ARMA 24-0238)"},
    {"carthage-marble", recall(16000 * psi), recall(35 * degree), "none at hand"},
    {"crab-orchard-sandstone", recall(26000 * psi), recall(45 * degree), "none at hand"},
    {"catoosa-shale", recall(4500 * psi), recall(17.5 * degree), "none at hand"},
    {"indiana-limestone", recall(8250 * psi), recall(35 * degree), "none at hand"},
}};

}  // namespace

double confining_pressure(const BottomHole& hole, Confinement confinement, double porosity) {
  const double permeable = hole.pressure - hole.pore_pressure;
  const double impermeable = permeable + (hole.overburden - hole.pressure) / 3.0;
  const double drained = confinement == Confinement::permeable ? 1.0
                         : confinement == Confinement::impermeable
                             ? 0.0
                             : std::clamp((porosity - 0.05) / 0.15, 0.0, 1.0);
  return std::max(0.0, drained * permeable + (1.0 - drained) * impermeable);
}

double strengthening(double friction_angle) {
  return (1.0 + std::sin(friction_angle)) / (1.0 - std::sin(friction_angle));
}

Strength strength_of(const RockMaterial& rock, const BottomHole& hole, Confinement confinement) {
  const double dp = confining_pressure(hole, confinement, rock.porosity);
  return {.unconfined = rock.unconfined,
          .confined = rock.unconfined + dp * strengthening(rock.friction_angle),
          .friction_angle = rock.friction_angle,
          .pressure = hole.pressure};
}

std::span<const KnownRock> known_rocks() { return rock_table; }

RockMaterial rock_named(std::string_view name) {
  const KnownRock& rock =
      find_by_name("rock", name, known_rocks(), [](const KnownRock& known) { return known.name; });
  return {std::string(name), rock.unconfined.value, rock.friction_angle.value};
}

Vec3 bedding_normal(double dip, double azimuth) {
  return {-std::sin(dip) * std::cos(azimuth), -std::sin(dip) * std::sin(azimuth), std::cos(dip)};

}  // namespace tdbd::forces

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
